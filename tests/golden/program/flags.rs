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
        let before_ = Self::situation_(self);
        let mut situation_ = before_;
        let was_state_: __PairState = situation_;
        let entered_s1__: bool;
        if self.first {
            entered_s1__ = true;
        } else {
            let clears_s1_s2__: bool = was_state_
                == __PairState::S1 && inputs_.b1;
            let clears_s2_s1__: bool = was_state_
                == __PairState::S2 && inputs_.b2;
            let left_s1__: bool = clears_s1_s2__;
            let left_s2__: bool = clears_s2_s1__;
            entered_s1__ = clears_s2_s1__
                && !(was_state_ == __PairState::S1 && !left_s1__);
            let entered_s2__: bool = clears_s1_s2__
                && !(was_state_ == __PairState::S2 && !left_s2__);
            if left_s1__ {
                situation_ = __PairState::NONE;
            }
            if left_s2__ {
                situation_ = __PairState::NONE;
            }
            if entered_s1__ {
                situation_ = __PairState::S1;
            }
            if entered_s2__ {
                situation_ = __PairState::S2;
            }
        }
        let on_s2_0__: bool = situation_ == __PairState::S2;
        let q_q_: bool = on_s2_0__;
        self.q = q_q_;
        self.first = false;
        if situation_ != before_ {
            self.situation[0usize] = self.situation[0usize] & 252u8
                | match situation_ {
                    __PairState::S1 => 1u8,
                    __PairState::S2 => 2u8,
                    _ => 0u8,
                };
        }
        outputs_.q = self.q;
        outputs_
    }
}
