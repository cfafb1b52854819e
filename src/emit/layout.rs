//! Tokens to text that is read: comments, documentation and blank lines.

use std::collections::HashSet;

use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// A line of comment where a statement may stand. Tokens have no comments, so it is a macro until it is printed.
pub(super) fn comment(text: &str) -> TokenStream {
    let text = visible(text);
    quote! { __comment!(#text); }
}

/// The user's text, so that what ends a line, cannot be seen or turns the direction of writing shows what it is.
pub(super) fn visible(text: &str) -> String {
    let shown = text.chars().map(|letter| match letter {
        '\t' => "    ".to_owned(),
        '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => letter.escape_unicode().to_string(),
        letter if letter.is_control() => letter.escape_unicode().to_string(),
        letter => letter.to_string(),
    });
    shown.collect()
}

/// A blank line where a statement or an item may stand.
pub(super) fn blank() -> TokenStream {
    quote! { __blank!(); }
}

/// Items with blank lines between them.
pub(super) fn apart(items: &[TokenStream]) -> TokenStream {
    let blank = blank();
    let (first, rest) = items.split_first().unzip();
    let rest = rest.into_iter().flatten();
    quote! { #first #(#blank #rest)* }
}

/// Paragraphs of documentation; empty ones are left out.
pub(super) fn doc(paragraphs: &[&str]) -> TokenStream {
    let paragraphs: Vec<_> = paragraphs.iter().map(|text| tamed(text)).filter(|text| !text.is_empty()).collect();
    let text = paragraphs.join("\n\n");
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote! { #(#[doc = #lines])* }
}

/// The user's text, so that nothing in it is taken for a test of Rust code.
fn tamed(text: &str) -> String {
    let mut in_code = false;
    let lines = text.trim().lines().map(|line| {
        let line = visible(line.trim_end());
        let bare = line.trim_start();
        let indented = line.len() - bare.len();
        let line = if indented > 3 { &line[indented - 3..] } else { line.as_str() };
        if !bare.starts_with("```") {
            return line.to_owned();
        }
        in_code = !in_code;
        if in_code { format!("{}```text", &line[..line.len() - bare.len()]) } else { line.to_owned() }
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The words in tokens.
pub(super) fn words(tokens: &TokenStream) -> HashSet<String> {
    let mut found = HashSet::new();
    let mut waiting = vec![tokens.clone()];
    while let Some(tokens) = waiting.pop() {
        for token in tokens {
            match token {
                TokenTree::Ident(word) => {
                    found.insert(word.to_string());
                }
                TokenTree::Group(group) => waiting.push(group.stream()),
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
        }
    }
    found
}

/// The text of items.
pub(super) fn print(items: &TokenStream) -> String {
    // Tokens that are no items are a fault of ours that the compiler of the text will name.
    let Ok(file) = syn::parse2::<syn::File>(items.clone()) else { return items.to_string() };
    let text = prettyplease::unparse(&file);
    let (mut lines, mut rest) = (Vec::new(), text.lines());
    while let Some(line) = rest.next() {
        let code = line.trim_start();
        let indentation = &line[..line.len() - code.len()];
        // A long one is broken behind its parenthesis.
        let remark = match code {
            "__comment!(" => (rest.next(), rest.next()).0.map(str::trim),
            code => code.strip_prefix("__comment!(").and_then(|text| text.strip_suffix(");")),
        };
        match remark
            .map(|text| syn::parse_str::<syn::LitStr>(text).map_or_else(|_| text.to_owned(), |text| text.value()))
        {
            Some(remark) => lines.push(format!("{indentation}// {remark}")),
            None if code == "__blank!();" => lines.push(String::new()),
            None => lines.push(line.to_owned()),
        }
    }
    lines.join("\n") + "\n"
}

/// A number as a literal of the emitted type: the shortest one that is read back to the same bits.
pub(super) fn number(value: f64, float: super::Float) -> TokenStream {
    let text = match float {
        super::Float::F64 => format!("{:?}", value.abs()),
        super::Float::F32 => format!("{:?}", (value as f32).abs()),
    };
    let literal = text.parse::<proc_macro2::Literal>().map(ToTokens::into_token_stream).unwrap_or_default();
    if value.is_sign_negative() {
        quote! { -#literal }
    } else {
        literal
    }
}

/// A count of nanoseconds with its digits in groups of three.
pub(super) fn nanoseconds(count: u64) -> TokenStream {
    let digits = count.to_string();
    let mut grouped = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            grouped.push('_');
        }
        grouped.push(digit);
    }
    grouped.parse::<proc_macro2::Literal>().map(ToTokens::into_token_stream).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_blank_lines_are_printed() {
        let long = "word ".repeat(30);
        let (remark, long_remark) = (comment("a \"b\" // c"), comment(long.trim()));
        let (blank, doc) = (blank(), doc(&["One.\n\n    two", "", "```\nx\n```"]));
        let text = print(&quote! { #doc fn f() { #remark g(); } #blank fn g() { #long_remark } });
        let expected = "/// One.\n///\n///    two\n///\n/// ```text\n/// x\n/// ```\nfn f() {\n    // a \"b\" // c\n    g();\n}\n\nfn g() {\n";
        assert_eq!(text, format!("{expected}    // {}\n}}\n", long.trim()));
    }

    #[test]
    fn the_users_text_stays_on_its_line() {
        assert_eq!(visible("a\nfn b()\u{202e}\r\té"), "a\\u{a}fn b()\\u{202e}\\u{d}    é");
        let (doc, remark) = (doc(&["One\u{2067}.\n\tTwo"]), comment("a\rb"));
        let text = print(&quote! { #doc fn f() { #remark } });
        assert_eq!(text, "/// One\\u{2067}.\n///    Two\nfn f() {\n    // a\\u{d}b\n}\n");
    }

    #[test]
    fn numbers_are_read_back_to_the_same_bits() {
        for value in [0.1, -4.0, 1e300, -2.094_395_102_393_195_3, 5e-324, -0.0] {
            let text = number(value, super::super::Float::F64).to_string().replace(' ', "");
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
        assert_eq!(number(0.1, super::super::Float::F32).to_string(), "0.1");
        assert_eq!(nanoseconds(2_000_000_000).to_string(), "2_000_000_000");
        assert_eq!([999, 1000].map(|count| nanoseconds(count).to_string()), ["999", "1_000"]);
    }
}
