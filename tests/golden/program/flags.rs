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
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &PairInputs,
        #[cfg(doc)]
        inputs: &PairInputs,
    ) -> PairOutputs {
        let mut outputs_ = PairOutputs { q: false };
        let was_s1_x_: bool = (self.situation[0usize] & 1u8 != 0);
        let was_s2_x_: bool = (self.situation[0usize] & 2u8 != 0);
        let entered_s1__: bool;
        if self.first {
            entered_s1__ = true;
        } else {
            let clears_s1_s2__: bool = was_s1_x_ && inputs_.b1;
            let clears_s2_s1__: bool = was_s2_x_ && inputs_.b2;
            let left_s1__: bool = clears_s1_s2__;
            let left_s2__: bool = clears_s2_s1__;
            entered_s1__ = clears_s2_s1__ && !(was_s1_x_ && !left_s1__);
            let entered_s2__: bool = clears_s1_s2__
                && !(was_s2_x_ && !left_s2__);
            if left_s1__ {
                self.situation[0usize] &= !1u8;
            }
            if left_s2__ {
                self.situation[0usize] &= !2u8;
            }
            if entered_s1__ {
                self.situation[0usize] |= 1u8;
            }
            if entered_s2__ {
                self.situation[0usize] |= 2u8;
            }
        }
        let on_s2_0__: bool = (self.situation[0usize] & 2u8 != 0);
        let q_q_: bool = on_s2_0__;
        self.q = q_q_;
        self.first = false;
        outputs_.q = self.q;
        outputs_
    }
}
