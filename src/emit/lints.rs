//! The lints that emitted code does not keep, each with its reason.

use proc_macro2::TokenStream;
use quote::quote;

/// Lints that are on by default or pedantic and that some emitted module leaves out, by their reason. All others are
/// kept, the compiler's and clippy's.
pub const LINTS: [(&str, &[&str]); 6] = [
    (
        "numbers are exact to the last bit",
        &["clippy::approx_constant", "clippy::cast_precision_loss", "clippy::float_cmp", "clippy::unreadable_literal"],
    ),
    (
        "names and documentation are the user's",
        &[
            "clippy::doc_lazy_continuation",
            "clippy::doc_markdown",
            "clippy::doc_overindented_list_items",
            "clippy::enum_variant_names",
            "clippy::many_single_char_names",
            "clippy::missing_errors_doc",
            "clippy::module_inception",
            "clippy::similar_names",
            "clippy::struct_field_names",
            "clippy::wrong_self_convention",
        ],
    ),
    ("a robot need not use everything", &["clippy::unnecessary_wraps", "clippy::unused_self", "dead_code"]),
    ("strengths stay in registers", &["clippy::inline_always"]),
    (
        "sizes are the user's",
        &[
            "clippy::fn_params_excessive_bools",
            "clippy::large_enum_variant",
            "clippy::struct_excessive_bools",
            "clippy::too_many_arguments",
            "clippy::too_many_lines",
            "clippy::trivially_copy_pass_by_ref",
            "clippy::type_complexity",
        ],
    ),
    (
        "conditions are the user's",
        &[
            "clippy::double_comparisons",
            "clippy::eq_op",
            "clippy::if_same_then_else",
            "clippy::ifs_same_cond",
            "clippy::manual_range_contains",
            "clippy::match_same_arms",
            "clippy::neg_cmp_op_on_partial_ord",
            "clippy::nonminimal_bool",
            "clippy::overly_complex_bool_expr",
            "clippy::same_functions_in_if_condition",
        ],
    ),
];

pub(super) fn of_kernel() -> TokenStream {
    allowed(&LINTS[..2])
}

pub(super) fn of_network() -> TokenStream {
    allowed(&LINTS[..5])
}

pub(super) fn of_diagram() -> TokenStream {
    allowed(&LINTS)
}

/// Of a method that brings up to the tick what is remembered, whatever else it does.
pub(super) fn of_remembering() -> TokenStream {
    quote! { #[allow(unused_variables, reason = "what is remembered goes on")] }
}

fn allowed(groups: &[(&str, &[&str])]) -> TokenStream {
    let groups = groups.iter().map(|(reason, names)| {
        let names = names.iter().filter_map(|name| name.parse::<TokenStream>().ok());
        quote! { #[allow(#(#names,)* reason = #reason)] }
    });
    quote! { #(#groups)* }
}
