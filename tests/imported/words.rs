// Imported from words.st by cargo grafcet.
//
// Renamed in Words:
//   eMode is EMode
//   eOff is EMode::EOff
//   eAuto is EMode::EAuto
//   eHand is EMode::EHand
//   Words_dir is WordsDir

use grafcet::grafcet;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EMode {
    #[default]
    EOff = 0,
    EAuto = 1,
    EHand = 5,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colour {
    Dark,
    #[default]
    Green,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WordsDir {
    #[default]
    Left,
    Right,
}

grafcet! {
    /// What structured text has for actions, in one chart: enums, CASE, loops, functions.
    pub sfc Words {
        input mode: EMode in {EOff, EAuto, EHand};
        input go: bool;
        input n, fast: i16;
        input w: u16;
        output state: EMode = EMode::EOff;
        output lamp, q: bool;
        output out: i16;
        output col: Colour = Colour::Green;
        output sum: i32;
        output bits: u16;
        var k: i16;
        var last: EMode in {EOff, EAuto, EHand} = EMode::EHand;
        var dir: WordsDir in {Left, Right} = WordsDir::Left;

        initial step Init;
        step Cases {
            // both
            P1 {
                match mode {
                    EMode::EOff => state = EMode::EOff,
                    EMode::EAuto | EMode::EHand => {
                        state = EMode::EHand;
                        last = mode;
                    }
                }
                dir = WordsDir::Right;
                col = Colour::Dark;
            }
            P1 {
                match n {
                    1 => out = 3,
                    2 | 4..=7 => {
                        out = 4;
                        if go {
                            out = 5;
                        }
                    }
                    -1 => {}
                    _ => out = 9,
                }
            }
            P lamp;
        }
        step Loops {
            // ten
            P1 {
                sum = 0;
                for i in 1_i16..=4 {
                    sum = sum + (i as i32);
                }
                for j in (0..=10_i16).rev().step_by(2) {
                    if j == 4 {
                        break;
                    }
                    if j == 8 {
                        continue;
                    }
                    sum = sum + 100;
                }
                for _ in 1..=3 {
                    sum = sum * 2;
                }
            }
            P1 {
                k = 1;
                while k <= n {
                    out = out + 1;
                    k += 1;
                }
                while out > 3 {
                    out = out - 3;
                }
                loop {
                    out = out + 10;
                    if out > 25 {
                        break;
                    }
                }
                q = k == n + 1;
            }
        }
        step Functions {
            P1 {
                out = n.abs() + n.min(5) + n.max(1).max(7);
                bits = (w << 4) | (w >> 12) ^ w.rotate_left(1) & !w;
                sum = (n as i32) * 1000 - i32::from(go);
                k = if go { 2 } else { 1 };
                q = n + 3 + 1 > 4;
            }
        }

        Init -[go && mode == EMode::EAuto]-> Cases -[last != EMode::EHand && dir == WordsDir::Right]-> Loops
            -[n.max(0).min(10) > 3 && (if go { n } else { 1 }) == 1]-> Functions
            -[!(w & (1 << 3) != 0) && fast > 2]-> Init;
    }
}
