//! Tokens that stand written out in the compiler's source, with places for others: what `quote!` of the crate `quote` makes, and the very
//! same tokens.
//!
//! That one is a call for each token, twelve thousand in this crate, which whoever uses the macro compiles. Here the text is read when
//! it is needed, and only places are calls. It is a text that rustc has read as tokens before, so that it is not checked again; characters in
//! single quotes and raw identifiers it has none.

use std::mem;

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, TokenStreamExt};

use crate::place;

/// A text that is read from one place to the next.
pub(crate) struct Text {
    source: &'static str,
    /// How much of it has been read, in bytes.
    read: usize,
    span: Span,
    /// What has been read of the innermost group.
    tokens: TokenStream,
    /// The groups around it, outermost first: how each inner one begins, and what stands before that.
    outer: Vec<(Delimiter, TokenStream)>,
}

impl Text {
    /// Its tokens stand at the chart's keyword.
    pub(crate) fn new(text: &'static str) -> Self {
        Self { source: text, read: 0, span: place::here(), tokens: TokenStream::new(), outer: Vec::new() }
    }

    /// Reads up to the next place and past it, and puts `tokens` there.
    pub(crate) fn put(&mut self, tokens: &dyn ToTokens) {
        while self.read() {}
        tokens.to_tokens(&mut self.tokens);
    }

    /// Reads what is after the last place.
    pub(crate) fn end(mut self) -> TokenStream {
        while self.read() {}
        self.tokens
    }

    /// Reads one token; or a place, or the end, where it says no.
    fn read(&mut self) -> bool {
        let start = self.take();
        let token = &self.source.as_bytes()[start..self.read];
        match token {
            [] => return false,
            b"#" => match self.source.as_bytes()[self.next()..] {
                [b'[', ..] => self.operator(token),
                [b'(', ..] => return self.pass_repetition(),
                _ => {
                    self.take();
                    return false;
                }
            },
            b"(" => self.open(Delimiter::Parenthesis),
            b"[" => self.open(Delimiter::Bracket),
            b"{" => self.open(Delimiter::Brace),
            b")" | b"]" | b"}" => self.close(),
            // Of a lifetime, whose name comes next.
            b"'" => self.tokens.append(located(Punct::new('\'', Spacing::Joint), self.span)),
            [b'"' | b'0'..=b'9', ..] | [b'r', b'"' | b'#', ..] => {
                let literal = self.source[start..self.read].parse::<Literal>().expect("rustc has read it");
                self.tokens.append(located(literal, self.span));
            }
            [first, ..] if is_of_word(*first) => {
                self.tokens.append(Ident::new(&self.source[start..self.read], self.span));
            }
            _ => self.operator(token),
        }
        true
    }

    /// What is repeated, `#(…),*`, whose tokens somebody else makes.
    fn pass_repetition(&mut self) -> bool {
        let mut depth = 0;
        loop {
            let start = self.take();
            match &self.source.as_bytes()[start..self.read] {
                b"(" | b"[" | b"{" => depth += 1,
                b")" | b"]" | b"}" => depth -= 1,
                b"*" if depth == 0 => return false,
                _ => {}
            }
        }
    }

    /// Reads past the next token and says where it begins; at the end there is none and it is empty.
    fn take(&mut self) -> usize {
        let start = self.next();
        self.read = start + length(&self.source.as_bytes()[start..]);
        start
    }

    /// Where the next token begins. This and what it calls runs without optimisation, some thousand times for a chart: hence no iterators.
    fn next(&self) -> usize {
        let bytes = self.source.as_bytes();
        let mut start = self.read;
        while start < bytes.len() && bytes[start].is_ascii_whitespace() {
            start += 1;
        }
        start
    }

    fn open(&mut self, delimiter: Delimiter) {
        self.outer.push((delimiter, mem::take(&mut self.tokens)));
    }

    fn close(&mut self) {
        if let Some((delimiter, before)) = self.outer.pop() {
            let group = Group::new(delimiter, mem::replace(&mut self.tokens, before));
            self.tokens.append(located(group, self.span));
        }
    }

    fn operator(&mut self, operator: &[u8]) {
        let mut index = 0;
        while index < operator.len() {
            let spacing = if index + 1 < operator.len() { Spacing::Joint } else { Spacing::Alone };
            self.tokens.append(located(Punct::new(char::from(operator[index]), spacing), self.span));
            index += 1;
        }
    }
}

fn located(token: impl Into<TokenTree>, span: Span) -> TokenTree {
    let mut token = token.into();
    token.set_span(span);
    token
}

/// How long the first token of a text is.
fn length(text: &[u8]) -> usize {
    match text {
        [] => 0,
        [b'"', ..] => string(text),
        [b'r', b'"' | b'#', ..] => raw_string(text),
        [b'0'..=b'9', ..] => number(text),
        [first, ..] if is_of_word(*first) => word(text),
        [b'.', b'.', b'.' | b'=', ..] | [b'<', b'<', b'=', ..] | [b'>', b'>', b'=', ..] => 3,
        [b'+' | b'-' | b'*' | b'/' | b'%' | b'^' | b'&' | b'|' | b'=' | b'!' | b'<' | b'>', b'=', ..]
        | [b'-' | b'=' | b'>', b'>', ..]
        | [b'<', b'<' | b'-', ..]
        | [b'&', b'&', ..]
        | [b'|', b'|', ..]
        | [b':', b':', ..]
        | [b'.', b'.', ..] => 2,
        _ => 1,
    }
}

fn is_of_word(byte: u8) -> bool {
    matches!(byte, b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'0'..=b'9')
}

fn word(text: &[u8]) -> usize {
    let mut end = 0;
    while end < text.len() && is_of_word(text[end]) {
        end += 1;
    }
    end
}

/// With its fraction and its suffix.
fn number(text: &[u8]) -> usize {
    let end = word(text);
    match &text[end..] {
        [b'.', b'0'..=b'9', ..] => end + 1 + word(&text[end + 1..]),
        _ => end,
    }
}

fn string(text: &[u8]) -> usize {
    let mut end = 1;
    while text[end] != b'"' {
        end += if text[end] == b'\\' { 2 } else { 1 };
    }
    end + 1
}

/// `r"…"`, `r#"…"#`: the text of a documentation, among others.
fn raw_string(text: &[u8]) -> usize {
    let mut hashes = 0;
    while text[1 + hashes] == b'#' {
        hashes += 1;
    }
    let mut end = hashes + 2;
    while text[end] != b'"' || text[end + 1..].iter().take_while(|byte| **byte == b'#').count() < hashes {
        end += 1;
    }
    end + 1 + hashes
}

/// As that of the crate `quote`, with its tokens at the chart's keyword.
macro_rules! quote {
    ($($tokens:tt)*) => {{
        #[allow(unused_mut, reason = "a text without places")]
        let mut text = $crate::quoted::Text::new(::core::stringify!($($tokens)*));
        $crate::quoted::fill!(text (@ @ @ $($tokens)*) (@ @ $($tokens)* @) (@ $($tokens)* @ @) ($($tokens)* @ @ @));
        text.end()
    }};
}
pub(crate) use quote;

/// Puts into the places what stands there. Each token is looked at with the one before it and the two after it, so that the macro need
/// not call itself for what comes next.
macro_rules! fill {
    ($text:ident ($($before:tt)*) ($($token:tt)*) ($($next:tt)*) ($($last:tt)*)) => {
        $($crate::quoted::fill_one!($text $before $token $next $last);)*
    };
}
pub(crate) use fill;

macro_rules! fill_one {
    ($text:ident # ($($inner:tt)*) * $last:tt) => {
        $text.put(&::quote::quote_spanned!($crate::place::here()=> #($($inner)*)*));
    };
    ($text:ident # ($($inner:tt)*) $separator:tt *) => {
        $text.put(&::quote::quote_spanned!($crate::place::here()=> #($($inner)*) $separator *));
    };
    ($text:ident # $name:ident $next:tt $last:tt) => { $text.put(&$name); };
    ($text:ident $before:tt ($($inner:tt)*) $next:tt $last:tt) => { $crate::quoted::fill_group!($text $($inner)*); };
    ($text:ident $before:tt [$($inner:tt)*] $next:tt $last:tt) => { $crate::quoted::fill_group!($text $($inner)*); };
    ($text:ident $before:tt {$($inner:tt)*} $next:tt $last:tt) => { $crate::quoted::fill_group!($text $($inner)*); };
    ($text:ident $before:tt $token:tt $next:tt $last:tt) => {};
}
pub(crate) use fill_one;

macro_rules! fill_group {
    ($text:ident $($inner:tt)*) => {
        $crate::quoted::fill!($text (@ @ @ $($inner)*) (@ @ $($inner)* @) (@ $($inner)* @ @) ($($inner)* @ @ @));
    };
}
pub(crate) use fill_group;

#[cfg(test)]
mod tests {
    use proc_macro2::{Ident, Span, TokenStream, TokenTree};

    use crate::place;

    /// Each token with what else tells it from others: `Punct` has its spacing.
    fn shown(tokens: TokenStream) -> Vec<String> {
        let mut all = Vec::new();
        for token in tokens {
            match token {
                TokenTree::Group(group) => {
                    all.push(format!("{:?}", group.delimiter()));
                    all.extend(shown(group.stream()));
                    all.push("end".to_owned());
                }
                TokenTree::Punct(punct) => all.push(format!("{} {:?}", punct.as_char(), punct.spacing())),
                TokenTree::Ident(ident) => all.push(format!("{ident}")),
                TokenTree::Literal(literal) => all.push(format!("literal {literal}")),
            }
        }
        all
    }

    macro_rules! as_the_crate_does {
        ($($tokens:tt)*) => {
            assert_eq!(shown(super::quote!($($tokens)*)), shown(::quote::quote!($($tokens)*)));
        };
    }

    #[test]
    fn every_kind_of_token() {
        as_the_crate_does!();
        as_the_crate_does!(
            fn f<'m>(self: &'m mut Self, _: &'static [u8; 4]) -> Option<Vec<Vec<u8>>> {
                a_1[0].0
            }
        );
        as_the_crate_does!(<A<B>>::c; <A>::b; a..=b; a..b; ..; a::<B>(); |_| {}; || {}; *&a; &*a; &&a; -1; !a; x @ 1?; $);
        as_the_crate_does!(a = b; a == b; a => b; a != b; a <= b; a >= b; a < b; a < -1; a > b; a << b; a >> b);
        as_the_crate_does!(a += 1; a -= 1; a *= 1; a /= 1; a %= 1; a ^= 1; a &= 1; a |= 1; a <<= 1; a >>= 1; a ... b; a <- b);
        as_the_crate_does!(0; 1u8; 0xffu32; 1_000; 0.5; 1.5f32; 0..2; a.0.1; true);
        as_the_crate_does!("a \" ( # \\"; r"\"; r##"a "# b"##; r#""#; b);
        as_the_crate_does! {
            /// Says "this", `#that` and (more.
            #[allow(dead_code)]
            #[doc = "a"]
            fn r() {}
        }
    }

    #[test]
    fn places() {
        let (a, b) = (Ident::new("a", Span::call_site()), Some(::quote::quote!(b + (c))));
        let none: Option<TokenStream> = None;
        let text = "text";
        as_the_crate_does!(#a);
        as_the_crate_does!(#a #b);
        as_the_crate_does!(#a::#a::<#b>(#none, [#text, { x: #a }.#a], #none) #a);
        as_the_crate_does!(#[#a] #[doc = #text] fn #a() { #[inline] #b });
    }

    #[test]
    fn repetitions() {
        let names = ["a", "b", "c"].map(|name| Ident::new(name, Span::call_site()));
        let values = vec![1_usize, 2, 3];
        let (none, one): (Vec<usize>, _) = (Vec::new(), 7_u8);
        as_the_crate_does!(#(#names)*);
        as_the_crate_does!(f(#(#names,)*) { #(#names),* } #(#values)||* => { #(#values)&&* } + #(#values)|* => #one);
        as_the_crate_does!(#(#none)* #(#none),* #one #(#[a(")")] fn #names() -> #one { [#values] })* #one);
        as_the_crate_does!((#((#names))&&*) #(#names)=>* #one);
        as_the_crate_does!(#(*#names * [#values * 2];)* #(*#names),* * #one);
    }

    #[test]
    fn all_stands_at_the_keyword() {
        let keyword = "\n\n  sfc".parse::<TokenStream>().expect("a word").into_iter().next().expect("a word").span();
        let _keyword = place::AtKeyword::at(keyword);
        let place = |span: Span| (span.start().line, span.start().column);
        let name = Ident::new("name", Span::call_site());
        let places = |tokens: TokenStream| tokens.into_iter().map(|token| place(token.span())).collect::<Vec<_>>();
        assert_eq!(places(super::quote!(a 1 :: (b))), [place(keyword); 5]);
        let group = super::quote!((a 'b #name)).into_iter().next();
        let Some(TokenTree::Group(group)) = group else { panic!("no group") };
        let own = place(name.span());
        assert_eq!(places(group.stream()), [place(keyword), place(keyword), place(keyword), own]);
    }
}
