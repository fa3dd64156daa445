//! Token streams from bytes: charts, nearly charts, and nothing like a chart.
//!
//! Made of tokens, not of text, so that things come up which no text gives: groups without delimiters, spacing that
//! contradicts what follows, negative literals.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

use words::{LITERALS, OPERATORS, SEEDS, WORDS};

mod words;

/// The bytes that decide; after their end everything is zero.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn next(&mut self) -> u8 {
        let (first, rest) = self.0.split_first().unwrap_or((&0, &[]));
        self.0 = rest;
        *first
    }

    fn below(&mut self, end: usize) -> usize {
        let wide = if end > 256 { usize::from(self.next()) << 8 } else { 0 };
        (wide + usize::from(self.next())) % end.max(1)
    }

    fn pick<'t>(&mut self, table: &[&'t str]) -> &'t str {
        table[self.below(table.len())]
    }
}

/// What the bytes make.
pub(crate) fn tokens(bytes: &[u8]) -> TokenStream {
    let mut bytes = Bytes(bytes);
    match bytes.next() % 8 {
        0 => sequence(&mut bytes, 0),
        1 | 2 => chart(&mut bytes),
        _ => mutated(&mut bytes),
    }
}

fn ident(word: &str) -> TokenTree {
    Ident::new(word, Span::call_site()).into()
}

fn group(delimiter: Delimiter, content: TokenStream) -> TokenTree {
    Group::new(delimiter, content).into()
}

/// The characters of an operator, now and then spaced as no text would be.
fn operator(text: &str, bytes: &mut Bytes) -> TokenStream {
    let count = text.chars().count();
    let odd = bytes.next() == 255;
    let one = |(at, char)| {
        TokenTree::from(Punct::new(char, if (at + 1 < count) == odd { Spacing::Alone } else { Spacing::Joint }))
    };
    text.chars().enumerate().map(one).collect()
}

fn literal(bytes: &mut Bytes) -> TokenTree {
    match bytes.next() % 8 {
        0 => Literal::i32_unsuffixed(-5).into(),
        1 => Literal::f64_suffixed(-0.5).into(),
        _ => bytes.pick(LITERALS).parse::<Literal>().unwrap_or_else(|_| Literal::u8_suffixed(7)).into(),
    }
}

fn delimiter(bytes: &mut Bytes) -> Delimiter {
    match bytes.next() % 8 {
        0 | 1 => Delimiter::Bracket,
        2 | 3 => Delimiter::Parenthesis,
        4 => Delimiter::None,
        _ => Delimiter::Brace,
    }
}

/// One thing from the dictionary, with whatever is in it.
fn anything(bytes: &mut Bytes, depth: usize) -> TokenStream {
    match bytes.next() % 16 {
        0..=5 => ident(bytes.pick(WORDS)).into(),
        6 => TokenTree::from(Ident::new_raw(["step", "match", "A"][bytes.below(3)], Span::call_site())).into(),
        7..=10 => operator(bytes.pick(OPERATORS), bytes),
        11 | 12 => literal(bytes).into(),
        _ if depth > 40 => TokenStream::new(),
        _ => group(delimiter(bytes), sequence(bytes, depth + 1)).into(),
    }
}

fn sequence(bytes: &mut Bytes, depth: usize) -> TokenStream {
    let count = bytes.below(12);
    let mut tokens = TokenStream::new();
    for _ in 0..count {
        if bytes.0.is_empty() {
            break;
        }
        tokens.extend(anything(bytes, depth));
    }
    tokens
}

/// A chart of items that are right but for their names and types, and for a little noise.
fn chart(bytes: &mut Bytes) -> TokenStream {
    let header = if bytes.next() < 128 { "sfc M" } else { "pub grafcet M" };
    let mut tokens = parsed(header);
    let body = body(bytes, 0);
    tokens.extend([group(Delimiter::Brace, body)]);
    tokens
}

fn body(bytes: &mut Bytes, depth: usize) -> TokenStream {
    let mut tokens = parsed("input a, b: bool; output q: bool; var count: u16 = 0; initial step A;");
    for _ in 0..bytes.below(10) {
        tokens.extend(item(bytes, depth));
        if bytes.next() > 250 {
            tokens.extend(anything(bytes, depth));
        }
    }
    tokens
}

fn item(bytes: &mut Bytes, depth: usize) -> TokenStream {
    let (word, other) = (ident(bytes.pick(WORDS)), ident(bytes.pick(WORDS)));
    match bytes.next() % 12 {
        0 => fill("VAR NAME: bool; let OTHER = EXPR;", bytes, &word, &other, depth),
        1 => fill("param NAME: time = LITERAL; action OTHER(NAME: time);", bytes, &word, &other, depth),
        2..=4 => fill(
            "step NAME { Q q; Q LITERAL q if EXPR; Q count = EXPR; Q { EXPR; } on EXPR OTHER; }",
            bytes,
            &word,
            &other,
            depth,
        ),
        7 => {
            fill("A -[EXPR]-> OTHER; A -[else]-> NAME; (A, NAME) -[r: else => EXPR]-> A;", bytes, &word, &other, depth)
        }
        5..=6 => fill("NAME -[EXPR]-> OTHER -[go: EXPR => count = EXPR]-> (A, NAME);", bytes, &word, &other, depth),
        8 => fill("never EXPR; always EXPR => EXPR; home NAME; clock LITERAL;", bytes, &word, &other, depth),
        9 => fill("initial NAME step OTHER; force NAME { OTHER };", bytes, &word, &other, depth),
        10 if depth < 8 => {
            let head = ["macro step", "enclosing step", "partial"][bytes.below(3)];
            let mut tokens = parsed(head);
            tokens.extend([word, group(Delimiter::Brace, body(bytes, depth + 1))]);
            tokens
        }
        _ => fill("() -[EXPR]-> NAME; OTHER -[EXPR]-> (); A -> B; A -[EXPR]-[EXPR]-> B;", bytes, &word, &other, depth),
    }
}

/// A pattern with its capital words filled in.
fn fill(pattern: &str, bytes: &mut Bytes, word: &TokenTree, other: &TokenTree, depth: usize) -> TokenStream {
    replace(parsed(pattern), &mut |name| match name {
        "NAME" => Some(word.clone().into()),
        "OTHER" => Some(other.clone().into()),
        "VAR" => Some(ident(["input", "output", "var", "param"][bytes.below(4)]).into()),
        "Q" => Some(ident(["N", "S", "R", "L", "D", "P", "P1", "P0", "SD", "DS", "SL"][bytes.below(11)]).into()),
        "LITERAL" => Some(literal(bytes).into()),
        "EXPR" => Some(expression(bytes, depth)),
        _ => None,
    })
}

fn replace(tokens: TokenStream, with: &mut impl FnMut(&str) -> Option<TokenStream>) -> TokenStream {
    let mut replaced = TokenStream::new();
    for tree in tokens {
        replaced.extend(match tree {
            TokenTree::Group(it) => group(it.delimiter(), replace(it.stream(), with)).into(),
            TokenTree::Ident(it) => with(&it.to_string()).unwrap_or_else(|| TokenTree::from(it).into()),
            other => other.into(),
        });
    }
    replaced
}

fn expression(bytes: &mut Bytes, depth: usize) -> TokenStream {
    let patterns = [
        "a",
        "b",
        "true",
        "A.X",
        "A.T > 5s",
        "5s/A",
        "count > 3",
        "EXPR && EXPR",
        "EXPR || EXPR",
        "!EXPR",
        "!(EXPR)",
        "rising(EXPR)",
        "falling(EXPR)",
        "LITERAL/(EXPR)/LITERAL",
        "if EXPR { EXPR } else { EXPR }",
        "count == LITERAL",
        "match count { 0 => EXPR, n => n > 1 }",
        "NAME",
        "{ let x = EXPR; x }",
        "(|x| x)(EXPR)",
        "-EXPR",
        "LITERAL/NAME",
    ];
    if depth > 12 || bytes.0.is_empty() {
        return parsed("a");
    }
    if bytes.next() > 250 {
        return anything(bytes, depth);
    }
    let pattern = bytes.pick(&patterns);
    let word = ident(bytes.pick(WORDS));
    fill(pattern, bytes, &word, &word, depth + 3)
}

/// Tokens of a text of ours.
fn parsed(text: &str) -> TokenStream {
    text.parse().unwrap_or_default()
}

/// A seed with a few things changed.
fn mutated(bytes: &mut Bytes) -> TokenStream {
    let seeds = SEEDS.split("====").collect::<Vec<_>>();
    let mut tokens = parsed(bytes.pick(&seeds));
    for _ in 0..=bytes.below(6) {
        let mut at = bytes.below(count(&tokens));
        tokens = change(tokens, &mut at, bytes);
    }
    for _ in 0..bytes.below(4) {
        let mut at = bytes.below(count(&tokens));
        tokens = passed_on(tokens, &mut at, bytes);
    }
    tokens
}

/// A few tokens from the one with the number `at` on, as a macro of `macro_rules` hands them over; it counts down.
fn passed_on(tokens: TokenStream, at: &mut usize, bytes: &mut Bytes) -> TokenStream {
    let mut changed = TokenStream::new();
    let mut tokens = tokens.into_iter();
    while let Some(tree) = tokens.next() {
        let here = *at == 0;
        *at = at.wrapping_sub(1);
        changed.extend([match tree {
            tree if here => {
                let before = parsed(["", "", "", "#[allow(unused)]", "#![a]", "let x =", "pub", "#"][bytes.below(8)]);
                let count = bytes.below(6);
                group(Delimiter::None, before.into_iter().chain([tree]).chain(tokens.by_ref().take(count)).collect())
            }
            TokenTree::Group(it) => group(it.delimiter(), passed_on(it.stream(), at, bytes)),
            other => other,
        }]);
    }
    changed
}

/// How many tokens there are on all levels.
fn count(tokens: &TokenStream) -> usize {
    let inside = |tree| match tree {
        TokenTree::Group(it) => 1 + count(&it.stream()),
        _ => 1,
    };
    tokens.clone().into_iter().map(inside).sum()
}

/// Changes the token with the number `at`, which counts down.
fn change(tokens: TokenStream, at: &mut usize, bytes: &mut Bytes) -> TokenStream {
    let mut changed = TokenStream::new();
    let mut before = None;
    for tree in tokens {
        let here = *at == 0;
        *at = at.wrapping_sub(1);
        changed.extend(match tree {
            ref tree if here => mutation(tree.clone(), before.take(), bytes),
            TokenTree::Group(ref it) => group(it.delimiter(), change(it.stream(), at, bytes)).into(),
            ref other => other.clone().into(),
        });
        before = Some(tree);
    }
    changed
}

fn mutation(tree: TokenTree, before: Option<TokenTree>, bytes: &mut Bytes) -> TokenStream {
    let inside = match &tree {
        TokenTree::Group(it) => it.stream(),
        other => other.clone().into(),
    };
    match bytes.next() % 10 {
        0 | 1 => TokenStream::new(),
        2 => [tree.clone(), tree].into_iter().collect(),
        3 => anything(bytes, 0),
        4 => anything(bytes, 0).into_iter().chain([tree]).collect(),
        5 => before.into_iter().chain([tree]).collect(),
        6 => inside,
        7 => group(delimiter(bytes), inside).into(),
        8 => group(delimiter(bytes), tree.into()).into(),
        _ => std::iter::repeat_n(tree, 1 + bytes.below(60)).collect(),
    }
}
