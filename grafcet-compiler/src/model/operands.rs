//! The text of a condition: its operators, and which operands stand in parentheses.

use super::{Binary, Model, Read, Tree, Unary};

/// How closely something binds, as in Rust. What binds less closely than what stands around it needs parentheses.
pub(crate) mod binds {
    /// Nothing stands around it.
    pub(crate) const ALONE: u8 = 0;
    pub(crate) const OR: u8 = 1;
    pub(crate) const AND: u8 = 2;
    pub(crate) const COMPARISON: u8 = 3;
    pub(crate) const BIT_OR: u8 = 4;
    pub(crate) const BIT_XOR: u8 = 5;
    pub(crate) const BIT_AND: u8 = 6;
    pub(crate) const SHIFT: u8 = 7;
    pub(crate) const SUM: u8 = 8;
    pub(crate) const PRODUCT: u8 = 9;
    pub(crate) const CAST: u8 = 10;
    pub(crate) const UNARY: u8 = 11;
    /// A name, a call: nothing takes a part of it away.
    pub(crate) const WHOLE: u8 = 12;
}

impl Binary {
    /// How the operator is written.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::And => "&&",
            Self::Or => "||",
            Self::BitAnd => "&",
            Self::BitOr => "|",
            Self::BitXor => "^",
            Self::Eq => "==",
            Self::Ne => "!=",
            Self::Lt => "<",
            Self::Le => "<=",
            Self::Gt => ">",
            Self::Ge => ">=",
            Self::Add => "+",
            Self::Sub => "-",
            Self::Mul => "*",
            Self::Div => "/",
            Self::Rem => "%",
            Self::Shl => "<<",
            Self::Shr => ">>",
        }
    }

    /// Whether its value is a boolean that tells how its operands compare.
    #[must_use]
    pub const fn is_comparison(self) -> bool {
        self.binds() == binds::COMPARISON
    }

    /// How closely it binds.
    pub(crate) const fn binds(self) -> u8 {
        match self {
            Self::Or => binds::OR,
            Self::And => binds::AND,
            Self::Eq | Self::Ne | Self::Lt | Self::Le | Self::Gt | Self::Ge => binds::COMPARISON,
            Self::BitOr => binds::BIT_OR,
            Self::BitXor => binds::BIT_XOR,
            Self::BitAnd => binds::BIT_AND,
            Self::Shl | Self::Shr => binds::SHIFT,
            Self::Add | Self::Sub => binds::SUM,
            Self::Mul | Self::Div | Self::Rem => binds::PRODUCT,
        }
    }

    /// How closely its operands have to bind. Operators from the left, comparisons not in a row.
    const fn operands(self) -> (u8, u8) {
        let binds = self.binds();
        let left = if self.is_comparison() { binds + 1 } else { binds };
        (left, binds + 1)
    }
}

/// What is told of a condition in different words: what it reads.
pub(crate) trait Leaves {
    fn model(&self) -> &Model;

    /// What is read, beside something that binds so closely.
    fn read(&self, read: Read, around: u8) -> String;

    /// Rust that is not looked into, and how closely that binds.
    fn rust(&self, text: &str, reads: &[Read]) -> (String, u8);

    /// How closely an operand has to bind, where Rust asks for this.
    fn operand(&self, binds: u8) -> u8 {
        binds
    }
}

/// A condition beside something that binds so closely.
pub(crate) fn text(leaves: &dyn Leaves, tree: &Tree, around: u8) -> String {
    let (text, binds) = match tree {
        Tree::Bool(value) => (value.to_string(), binds::WHOLE),
        Tree::Int(value) => (value.to_string(), binds::WHOLE),
        Tree::Read(read) => return leaves.read(*read, around),
        Tree::Elapsed(time, step) => return leaves.read(Read::Elapsed(*time, *step), around),
        Tree::MacroElapsed(time, id) => return leaves.read(Read::MacroElapsed(*time, *id), around),
        Tree::Unary(operator, inner) => {
            let sign = if *operator == Unary::Not { "!" } else { "-" };
            (format!("{sign}{}", text(leaves, inner, leaves.operand(binds::UNARY))), binds::UNARY)
        }
        Tree::Binary(operator, a, b) => {
            let (left, right) = operator.operands();
            let (left, right) = (operand(leaves, a, b, left), operand(leaves, b, a, right));
            (format!("{left} {} {right}", operator.symbol()), operator.binds())
        }
        Tree::Opaque { text, reads, .. } => leaves.rust(text, reads),
    };
    if binds < around { format!("({text})") } else { text }
}

/// A variant by its name, where an enum is compared.
fn operand(leaves: &dyn Leaves, tree: &Tree, other: &Tree, binds: u8) -> String {
    let variant = leaves.model().variant_text(other, tree);
    variant.unwrap_or_else(|| text(leaves, tree, leaves.operand(binds)))
}

/// In a sentence: reads as the user writes them, and each operation that is an operand in parentheses, so that nobody has to know
/// which operator binds more closely.
impl Leaves for Model {
    fn model(&self) -> &Model {
        self
    }

    fn read(&self, read: Read, _: u8) -> String {
        self.read_text(read)
    }

    fn rust(&self, text: &str, _: &[Read]) -> (String, u8) {
        (text.to_owned(), of_rust(text))
    }

    fn operand(&self, _: u8) -> u8 {
        binds::UNARY
    }
}

/// How closely Rust binds that is no operator of a [`Tree`].
fn of_rust(text: &str) -> u8 {
    match syn::parse_str(text) {
        Ok(syn::Expr::Cast(_)) => binds::CAST,
        Ok(syn::Expr::Assign(_) | syn::Expr::Binary(_) | syn::Expr::Closure(_) | syn::Expr::Range(_)) => binds::ALONE,
        Ok(syn::Expr::Reference(_) | syn::Expr::Unary(_)) => binds::UNARY,
        _ => binds::WHOLE,
    }
}

#[cfg(test)]
mod tests {
    use super::{Leaves, text};
    use crate::diagnostic::Sink;
    use crate::model::{self, Binary, Id, InputId, Model, Name, Read, Tree, Unary};
    use crate::parse;

    const ALL: [Binary; 18] = [
        Binary::And,
        Binary::Or,
        Binary::BitAnd,
        Binary::BitOr,
        Binary::BitXor,
        Binary::Eq,
        Binary::Ne,
        Binary::Lt,
        Binary::Le,
        Binary::Gt,
        Binary::Ge,
        Binary::Add,
        Binary::Sub,
        Binary::Mul,
        Binary::Div,
        Binary::Rem,
        Binary::Shl,
        Binary::Shr,
    ];

    /// As sparing with parentheses as Rust.
    struct Sparing(Model);

    impl Leaves for Sparing {
        fn model(&self) -> &Model {
            &self.0
        }

        fn read(&self, read: Read, _: u8) -> String {
            self.0.read_text(read)
        }

        fn rust(&self, text: &str, reads: &[Read]) -> (String, u8) {
            self.0.rust(text, reads)
        }
    }

    fn chart() -> Model {
        let text = "sfc C { input a, b, c: u8; initial step On; step Off; On -[true]-> Off -[true]-> On; }";
        let mut sink = Sink::new();
        let chart = parse::chart(text.parse().expect("tokens"), &mut sink).expect("a chart");
        model::resolve(&chart, &mut sink)
    }

    fn input(index: usize) -> Tree {
        Tree::Read(Read::Name(Name::Input(InputId::new(index))))
    }

    fn two(operator: Binary, a: Tree, b: Tree) -> Tree {
        Tree::Binary(operator, Box::new(a), Box::new(b))
    }

    fn one(operator: Unary, of: Tree) -> Tree {
        Tree::Unary(operator, Box::new(of))
    }

    fn rust(text: &str) -> Tree {
        let (text, reads) = (text.to_owned(), Vec::new());
        Tree::Opaque { text, reads, call: None, whole: true, open: false, of: None }
    }

    /// With parentheses around everything.
    fn meant(tree: &Tree) -> String {
        match tree {
            Tree::Read(Read::Name(Name::Input(id))) => ["a", "b", "c"][id.index()].to_owned(),
            Tree::Unary(operator, of) => format!("({}{})", if *operator == Unary::Not { "!" } else { "-" }, meant(of)),
            Tree::Binary(operator, a, b) => format!("({} {} {})", meant(a), operator.symbol(), meant(b)),
            Tree::Opaque { text, .. } => read_back(text),
            other => panic!("{other:?}"),
        }
    }

    /// The same of what Rust makes of a text.
    fn read_back(text: &str) -> String {
        fn of(expr: &syn::Expr) -> String {
            use quote::ToTokens as _;
            match expr {
                syn::Expr::Paren(inner) => of(&inner.expr),
                syn::Expr::Unary(unary) => format!("({}{})", unary.op.to_token_stream(), of(&unary.expr)),
                syn::Expr::Binary(binary) => {
                    format!("({} {} {})", of(&binary.left), binary.op.to_token_stream(), of(&binary.right))
                }
                syn::Expr::Cast(cast) => format!("({} as {})", of(&cast.expr), cast.ty.to_token_stream()),
                syn::Expr::MethodCall(call) => format!("{}.{}()", of(&call.receiver), call.method),
                other => other.to_token_stream().to_string(),
            }
        }
        of(&syn::parse_str(text).unwrap_or_else(|error| panic!("`{text}`: {error}")))
    }

    /// Asserts that both ways to write it say what is meant.
    fn says(sparing: &Sparing, tree: &Tree) {
        for text in [text(sparing, tree, 0), sparing.0.tree_text(tree)] {
            assert_eq!(read_back(&text), meant(tree), "`{text}`");
        }
    }

    #[test]
    fn parentheses_stand_where_another_operator_would_take_an_operand() {
        let sparing = Sparing(chart());
        for outer in ALL {
            for inner in ALL {
                says(&sparing, &two(outer, two(inner, input(0), input(1)), input(2)));
                says(&sparing, &two(outer, input(0), two(inner, input(1), input(2))));
            }
            for sign in [Unary::Not, Unary::Neg] {
                says(&sparing, &one(sign, two(outer, input(0), input(1))));
                says(&sparing, &two(outer, one(sign, input(0)), one(sign, input(1))));
                says(&sparing, &one(sign, one(Unary::Not, input(0))));
            }
            says(&sparing, &two(outer, input(0), rust("b as u8")));
            says(&sparing, &two(outer, rust("a.abs()"), rust("-b.abs()")));
            says(&sparing, &two(outer, rust("(-a).abs()"), rust("(b as i8).abs()")));
        }
        says(&sparing, &one(Unary::Neg, rust("a as i8")));
        says(&sparing, &one(Unary::Neg, rust("a.abs()")));
    }

    #[test]
    fn they_stand_nowhere_else() {
        let sparing = Sparing(chart());
        let (a, b, c) = (input(0), input(1), input(2));
        let written = |tree: &Tree| (text(&sparing, tree, 0), sparing.0.tree_text(tree));
        let both = |one: &str, other: &str| (one.to_owned(), other.to_owned());
        let mask = two(Binary::BitXor, a.clone(), two(Binary::BitAnd, b.clone(), c.clone()));
        assert_eq!(written(&mask), both("a ^ b & c", "a ^ (b & c)"));
        let mask = two(Binary::BitAnd, two(Binary::BitXor, a.clone(), b.clone()), c.clone());
        assert_eq!(written(&mask), both("(a ^ b) & c", "(a ^ b) & c"));
        let sum = two(Binary::Add, two(Binary::Shl, a.clone(), b.clone()), c.clone());
        assert_eq!(written(&sum), both("(a << b) + c", "(a << b) + c"));
        let sum = two(Binary::Sub, two(Binary::Sub, a, b), one(Unary::Not, c));
        assert_eq!(written(&sum), both("a - b - !c", "(a - b) - !c"));
    }

    #[test]
    fn comparisons() {
        let mut compare = ALL.to_vec();
        compare.retain(|operator| operator.is_comparison());
        assert_eq!(compare, [Binary::Eq, Binary::Ne, Binary::Lt, Binary::Le, Binary::Gt, Binary::Ge]);
        // What compares is mirrored, and mirrored twice the same.
        for operator in ALL {
            assert_eq!(operator.mirrored().mirrored(), operator);
            assert_eq!(operator.mirrored().is_comparison(), operator.is_comparison());
        }
    }

    #[test]
    fn rust_that_is_an_operand() {
        let model = chart();
        let below = |left: &str| model.tree_text(&two(Binary::Lt, rust(left), input(1)));
        assert_eq!(below("a as u8"), "(a as u8) < b");
        assert_eq!(below("a.abs()"), "a.abs() < b");
        assert_eq!(model.tree_text(&one(Unary::Not, rust("a as bool"))), "!(a as bool)");
    }
}
