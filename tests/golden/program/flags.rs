// Recorded by `cargo xtask bless`: state and cycle of the program, without the facade's path.

struct Pair {
    situation: [u8; 1usize],
    first: bool,
    q: bool,
}
impl Pair {
    const fn new() -> Self {
        Self {
            situation: [1u8],
            first: true,
            q: false,
        }
    }
}
impl Pair {
    fn cycle(&mut self, inputs: &PairInputs) -> PairOutputs {
        let mut outputs = PairOutputs { q: false };
        let was_s1_x: bool = (self.situation[0usize] & 1u8 != 0);
        let was_s2_x: bool = (self.situation[0usize] & 2u8 != 0);
        let entered_s1_: bool;
        if self.first {
            entered_s1_ = true;
        } else {
            let clears_s1_s2_: bool = was_s1_x && inputs.b1;
            let clears_s2_s1_: bool = was_s2_x && inputs.b2;
            let left_s1_: bool = clears_s1_s2_;
            let left_s2_: bool = clears_s2_s1_;
            entered_s1_ = clears_s2_s1_ && !(was_s1_x && !left_s1_);
            let entered_s2_: bool = clears_s1_s2_
                && !(was_s2_x && !left_s2_);
            if left_s1_ {
                self.situation[0usize] &= !1u8;
            }
            if left_s2_ {
                self.situation[0usize] &= !2u8;
            }
            if entered_s1_ {
                self.situation[0usize] |= 1u8;
            }
            if entered_s2_ {
                self.situation[0usize] |= 2u8;
            }
        }
        let on_s2_0_: bool = (self.situation[0usize] & 2u8 != 0);
        let q_q: bool = on_s2_0_;
        self.q = q_q;
        self.first = false;
        outputs.q = self.q;
        outputs
    }
}
