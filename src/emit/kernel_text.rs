//! The kernel, as text: what emitted code uses of it.

use std::collections::HashSet;

use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use super::{Emission, Float, layout, lints};

/// What the compiler computes with is what the robot computes with.
const KERNEL: &str = include_str!("../kernel.rs");

/// A module of the kernel's items that `user` names, and of those that they name in turn; nothing where it names none.
pub(super) fn module(emission: Emission<'_>, user: &TokenStream) -> TokenStream {
    let Ok(file) = syn::parse_str::<syn::File>(KERNEL) else { return TokenStream::new() };
    let mut used = HashSet::new();
    named(user.clone(), &mut used);
    // The kernel is in no order, so this goes round until nothing new is used.
    loop {
        let before = used.len();
        for item in &file.items {
            if let Some(item) = kept(item, &used) {
                used.extend(layout::words(&item));
            }
        }
        if used.len() == before {
            break;
        }
    }
    let items: Vec<_> = file
        .items
        .iter()
        .filter_map(|item| {
            let (kept, serde) = (kept(item, &used)?, emission.serde());
            Some(if matches!(item, syn::Item::Struct(_)) {
                quote! { #serde #kept }
            } else {
                kept
            })
        })
        .map(|item| match emission.options.float {
            Float::F64 => item,
            Float::F32 => in_single_precision(item),
        })
        .collect();
    if items.is_empty() {
        return TokenStream::new();
    }
    let (blank, allowed, items) = (layout::blank(), lints::of_kernel(), layout::apart(&items));
    let doc =
        layout::doc(&["What membership, strength, memory, time and chance are, as the compiler computes them too."]);
    quote! {
        #blank
        #doc
        #allowed
        mod kernel {
            #items
        }
    }
}

/// The import of a module that names something in the kernel.
pub(super) fn import(user: &TokenStream) -> Option<TokenStream> {
    let mut names = HashSet::new();
    named(user.clone(), &mut names);
    (!names.is_empty()).then(|| quote! { use super::kernel; })
}

/// An item without the methods that are not used; `None` for one that is not used itself.
fn kept(item: &syn::Item, used: &HashSet<String>) -> Option<TokenStream> {
    let is_used = |name: &Ident| used.contains(&name.to_string());
    match item {
        syn::Item::Fn(function) => is_used(&function.sig.ident).then(|| function.to_token_stream()),
        syn::Item::Struct(declared) => is_used(&declared.ident).then(|| declared.to_token_stream()),
        syn::Item::Impl(methods) => {
            let mut methods = methods.clone();
            methods.items.retain(|item| matches!(item, syn::ImplItem::Fn(method) if is_used(&method.sig.ident)));
            (!methods.items.is_empty()).then(|| methods.into_token_stream())
        }
        _ => None,
    }
}

/// What tokens name in the kernel: the words of every path behind `kernel::`.
fn named(tokens: TokenStream, names: &mut HashSet<String>) {
    let mut in_path = false;
    for token in tokens {
        match token {
            TokenTree::Ident(word) if word == "kernel" => in_path = true,
            TokenTree::Ident(word) if in_path => {
                names.insert(word.to_string());
            }
            TokenTree::Punct(mark) if mark.as_char() == ':' => {}
            TokenTree::Group(group) => {
                named(group.stream(), names);
                in_path = false;
            }
            _ => in_path = false,
        }
    }
}

/// Tokens with another type of numbers, and the functions of `libm` for it.
fn in_single_precision(tokens: TokenStream) -> TokenStream {
    let mut of_libm = false;
    let replaced = tokens.into_iter().map(|token| match token {
        TokenTree::Ident(word) if word == "f64" => TokenTree::Ident(Ident::new("f32", word.span())),
        TokenTree::Ident(word) if of_libm => {
            of_libm = false;
            TokenTree::Ident(Ident::new(&format!("{word}f"), word.span()))
        }
        TokenTree::Ident(word) => {
            of_libm = word == "libm";
            TokenTree::Ident(word)
        }
        TokenTree::Group(group) => TokenTree::Group(Group::new(group.delimiter(), in_single_precision(group.stream()))),
        token => token,
    });
    replaced.collect()
}
