// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __GateRegion0 {
    Rest,
    NONE,
    INIT,
}
enum __GateRegion1 {
    Raise,
    NONE,
}
enum __GateRegion2 {
    Lower,
    NONE,
}
impl Gate {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &GateInputs,
        #[cfg(doc)]
        inputs: &GateInputs,
    ) -> GateOutputs {
        let mut outputs_ = const {
            GateOutputs {
                up: false,
                down: false,
            }
        };
        let first_: bool = self.region_0 == __GateRegion0::INIT;
        if first_ {
            self.region_0 = __GateRegion0::Rest;
        }
        let inputs_ = core::hint::black_box(inputs_);
        loop {
            fence_on_armv6m();
            let was_state_rest_: __GateRegion0 = self.region_0;
            let was_state_raise_: __GateRegion1 = self.region_1;
            let was_state_lower_: __GateRegion2 = self.region_2;
            let clears_rest_raise_: bool = self.region_0
                == __GateRegion0::Rest && !self.edge0_before && inputs_.open;
            let clears_raise_rest_: bool = self.region_1
                == __GateRegion1::Raise && !inputs_.open;
            let clears_rest_lower_: bool = self.region_0
                == __GateRegion0::Rest && !self.edge1_before && inputs_.close;
            let clears_lower_rest_: bool = self.region_2
                == __GateRegion2::Lower && !inputs_.close;
            if clears_rest_raise_ || clears_rest_lower_ {
                self.region_0 = __GateRegion0::NONE;
            }
            if clears_raise_rest_ {
                self.region_1 = __GateRegion1::NONE;
            }
            if clears_lower_rest_ {
                self.region_2 = __GateRegion2::NONE;
            }
            if clears_raise_rest_ || clears_lower_rest_ {
                self.region_0 = __GateRegion0::Rest;
            }
            if clears_rest_raise_ {
                self.region_1 = __GateRegion1::Raise;
            }
            if clears_rest_lower_ {
                self.region_2 = __GateRegion2::Lower;
            }
            let mut moves_23__: bool = was_state_rest_
                != self.region_0;
            moves_23__ = moves_23__ || was_state_raise_ != self.region_1;
            moves_23__ = moves_23__ || was_state_lower_ != self.region_2;
            if !moves_23__ {
                break;
            }
            self.edge0_before = inputs_.open;
            self.edge1_before = inputs_.close;
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        self.edge0_before = inputs_.open;
        self.edge1_before = inputs_.close;
        match self.region_1 {
            __GateRegion1::Raise => {
                outputs_.up = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_2 {
            __GateRegion2::Lower => {
                outputs_.down = true;
            }
            _ => {}
        }
        outputs_
    }
}
impl Gate {
    /// One cycle that leads into a situation by hand, whatever the transition conditions say (decision A38): no transition clears, steps that
    /// are not named are left, named ones entered, each with its actions, and nothing of the steps in between runs.
    ///
    /// For commissioning: nothing that the compiler has proved of the chart's ways holds on this one.
    ///
    /// # Errors
    /// The chart is never in exactly these steps; then nothing has happened.
    #[allow(unused_assignments, unused_mut, unused_variables)]
    fn force(
        &mut self,
        #[cfg(not(doc))]
        steps_: &[GateStep],
        #[cfg(doc)]
        steps: &[GateStep],
        #[cfg(not(doc))]
        inputs_: &GateInputs,
        #[cfg(doc)]
        inputs: &GateInputs,
    ) -> Result<
        GateOutputs,
        ForceError<GateStep>,
    > {
        Possible::Listed(b"\x01\x03\x05\x02\x06\x04")
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__GateRegion0> = Option::None;
        let mut forced1_: Option<__GateRegion1> = Option::None;
        let mut forced2_: Option<__GateRegion2> = Option::None;
        for step_ in steps_ {
            match *step_ {
                GateStep::Rest => {
                    forced0_ = Option::Some(__GateRegion0::Rest);
                }
                GateStep::Raise => {
                    forced1_ = Option::Some(__GateRegion1::Raise);
                }
                GateStep::Lower => {
                    forced2_ = Option::Some(__GateRegion2::Lower);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => __GateRegion0::NONE,
        };
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __GateRegion1::NONE,
        };
        let forced2_ = match forced2_ {
            Option::Some(state_) => state_,
            Option::None => __GateRegion2::NONE,
        };
        Result::Ok({
            let mut outputs_ = const {
                GateOutputs {
                    up: false,
                    down: false,
                }
            };
            let edge0_now_: bool = inputs_.open;
            let edge1_now_: bool = inputs_.close;
            self.region_0 = forced0_;
            self.region_1 = forced1_;
            self.region_2 = forced2_;
            self.edge0_before = edge0_now_;
            self.edge1_before = edge1_now_;
            let was_state_raise_: __GateRegion1 = self.region_1;
            let was_state_lower_: __GateRegion2 = self.region_2;
            let next_up_: bool = was_state_raise_
                == __GateRegion1::Raise;
            let next_down_: bool = was_state_lower_
                == __GateRegion2::Lower;
            outputs_.up = next_up_;
            outputs_.down = next_down_;
            outputs_
        })
    }
}
