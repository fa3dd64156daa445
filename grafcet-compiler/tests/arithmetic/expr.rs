//! Random expressions of integers, and their values in a program that panics where a result does not fit into its type, and in one
//! that goes on.

pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % bound as u64).unwrap_or_default()
    }

    pub(crate) fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Ty {
    U8,
    I8,
    U16,
    I16,
}

impl Ty {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::U8 => "u8",
            Self::I8 => "i8",
            Self::U16 => "u16",
            Self::I16 => "i16",
        }
    }

    pub(crate) fn limits(self) -> (i64, i64) {
        match self {
            Self::U8 => (0, 255),
            Self::I8 => (-128, 127),
            Self::U16 => (0, 65_535),
            Self::I16 => (-32_768, 32_767),
        }
    }

    fn is_signed(self) -> bool {
        self.limits().0 < 0
    }

    fn fits(self, value: i64) -> bool {
        (self.limits().0..=self.limits().1).contains(&value)
    }

    fn wrapped(self, value: i64) -> i64 {
        let (low, high) = self.limits();
        (value - low).rem_euclid(high - low + 1) + low
    }
}

/// An expression with its text and its type.
pub(crate) enum Expr {
    Name(usize, Ty),
    Constant(i64, Ty),
    Binary(&'static str, Box<Expr>, Box<Expr>),
    Method(&'static str, Box<Expr>, Option<Box<Expr>>),
    Unary(&'static str, Box<Expr>),
    As(Ty, Box<Expr>),
}

/// How a program is built: one that panics has no value then.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Build {
    Checked,
    Wrapping,
}

pub(crate) const NAMES: [&str; 2] = ["lv", "lw"];

impl Expr {
    /// What is computed of constants alone does not compile where it does not fit.
    pub(crate) fn random(random: &mut Random, names: &[Ty], ty: Ty, depth: usize) -> Self {
        let made = Self::any(random, names, ty, depth);
        if made.is_constant() { Self::constant(random, ty) } else { made }
    }

    fn is_constant(&self) -> bool {
        match self {
            Self::Name(..) => false,
            Self::Constant(..) => true,
            Self::As(_, a) | Self::Unary(_, a) | Self::Method(_, a, None) => a.is_constant(),
            Self::Binary(_, a, b) | Self::Method(_, a, Some(b)) => a.is_constant() && b.is_constant(),
        }
    }

    fn any(random: &mut Random, names: &[Ty], ty: Ty, depth: usize) -> Self {
        let own: Vec<usize> = (0..names.len()).filter(|name| names[*name] == ty).collect();
        let kind = random.below(if depth == 0 { 3 } else { 12 });
        let make = |random: &mut Random| Box::new(Self::random(random, names, ty, depth.saturating_sub(1)));
        match kind {
            0..=2 if !own.is_empty() => Self::Name(random.of(&own), ty),
            0..=2 if random.below(3) > 0 => {
                let name = random.below(names.len());
                Self::As(ty, Box::new(Self::Name(name, names[name])))
            }
            0..=2 => Self::constant(random, ty),
            3 => {
                let other = random.of(&[Ty::U8, Ty::I8, Ty::U16, Ty::I16]);
                Self::As(ty, Box::new(Self::random(random, names, other, depth - 1)))
            }
            4 => match random.below(if ty.is_signed() { 4 } else { 1 }) {
                0 => Self::Unary("!", make(random)),
                1 => Self::Unary("-", make(random)),
                2 => Self::Method("abs", make(random), None),
                _ => Self::Method("signum", make(random), None),
            },
            5 | 6 => {
                let methods = [
                    "wrapping_add",
                    "wrapping_sub",
                    "wrapping_mul",
                    "saturating_add",
                    "saturating_sub",
                    "saturating_mul",
                    "min",
                    "max",
                ];
                let other = if random.below(2) == 0 { make(random) } else { Box::new(Self::constant(random, ty)) };
                Self::Method(random.of(&methods), make(random), Some(other))
            }
            7 => {
                let by = Self::Constant(random.of(&[1, 2, 3, 5, 10, 100]), ty);
                let (operator, a) = (random.of(&["/", "%", "div_euclid", "rem_euclid"]), make(random));
                if operator.len() == 1 {
                    Self::Binary(operator, a, Box::new(by))
                } else {
                    Self::Method(operator, a, Some(Box::new(by)))
                }
            }
            8 => {
                let by = Self::Constant(random.of(&[1, 2, 3, 7]), ty);
                Self::Binary(random.of(&["<<", ">>"]), make(random), Box::new(by))
            }
            9 => {
                let mask = Self::Constant(random.of(&[1, 2, 6, 15, 64]), ty);
                Self::Binary(random.of(&["&", "|", "^"]), make(random), Box::new(mask))
            }
            _ => {
                let other = if random.below(2) == 0 { make(random) } else { Box::new(Self::constant(random, ty)) };
                Self::Binary(random.of(&["+", "-", "*"]), make(random), other)
            }
        }
    }

    pub(crate) fn constant(random: &mut Random, ty: Ty) -> Self {
        let (low, high) = ty.limits();
        Self::Constant(random.of(&[0, 1, 2, 3, 5, 10, 100, high, high - 1, low, low + 1]), ty)
    }

    pub(crate) fn ty(&self) -> Ty {
        match self {
            Self::Name(_, ty) | Self::Constant(_, ty) | Self::As(ty, _) => *ty,
            Self::Binary(_, a, _) | Self::Method(_, a, _) | Self::Unary(_, a) => a.ty(),
        }
    }

    /// In parentheses that are always right.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Name(name, _) => NAMES[*name].to_owned(),
            // What a method is called on has to have a type.
            Self::Constant(value, ty) if *value < 0 => format!("({value}{})", ty.name()),
            Self::Constant(value, ty) => format!("{value}{}", ty.name()),
            Self::Binary(operator, a, b) => format!("({} {operator} {})", a.text(), b.text()),
            Self::Method(name, a, None) => format!("{}.{name}()", a.text()),
            Self::Method(name, a, Some(b)) => format!("{}.{name}({})", a.text(), b.text()),
            Self::Unary(operator, a) => format!("({operator}{})", a.text()),
            Self::As(ty, a) => format!("({} as {})", a.text(), ty.name()),
        }
    }

    pub(crate) fn value(&self, values: &[i64], build: Build) -> Option<i64> {
        let ty = self.ty();
        let fit = |value: i64| match build {
            Build::Checked if !ty.fits(value) => None,
            _ => Some(ty.wrapped(value)),
        };
        match self {
            Self::Name(name, _) => Some(values[*name]),
            Self::Constant(value, _) => Some(*value),
            Self::As(ty, a) => Some(ty.wrapped(a.value(values, build)?)),
            Self::Unary("-", a) => fit(-a.value(values, build)?),
            Self::Unary(_, a) => Some(ty.wrapped(!a.value(values, build)?)),
            Self::Method("abs", a, _) => fit(a.value(values, build)?.abs()),
            Self::Method("signum", a, _) => Some(a.value(values, build)?.signum()),
            Self::Method(name, a, b) => {
                let (a, b) = (a.value(values, build)?, b.as_ref()?.value(values, build)?);
                let (low, high) = ty.limits();
                Some(match *name {
                    "wrapping_add" => ty.wrapped(a + b),
                    "wrapping_sub" => ty.wrapped(a - b),
                    "wrapping_mul" => ty.wrapped(a * b),
                    "saturating_add" => (a + b).clamp(low, high),
                    "saturating_sub" => (a - b).clamp(low, high),
                    "saturating_mul" => (a * b).clamp(low, high),
                    "min" => a.min(b),
                    "max" => a.max(b),
                    "div_euclid" => a.div_euclid(b),
                    _ => a.rem_euclid(b),
                })
            }
            Self::Binary(operator, a, b) => {
                let (a, b) = (a.value(values, build)?, b.value(values, build)?);
                match *operator {
                    "+" => fit(a + b),
                    "-" => fit(a - b),
                    "*" => fit(a * b),
                    "/" => Some(a / b),
                    "%" => Some(a % b),
                    "<<" => Some(ty.wrapped(a << b)),
                    ">>" => Some(a >> b),
                    "&" => Some(a & b),
                    "|" => Some(a | b),
                    _ => Some(a ^ b),
                }
            }
        }
    }
}
