// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __FloatRegion0 {
    Rest,
    NONE,
    INIT,
}
enum __FloatRegion1 {
    Fill,
    NONE,
}
enum __FloatRegion2 {
    Drain,
    NONE,
}
impl Float {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &FloatInputs,
        #[cfg(doc)]
        inputs: &FloatInputs,
    ) -> FloatOutputs {
        let mut outputs_ = const {
            FloatOutputs {
                fill: false,
                drain: false,
            }
        };
        let first_: bool = self.region_0 == __FloatRegion0::INIT;
        if first_ {
            self.region_0 = __FloatRegion0::Rest;
        }
        let inputs_ = core::hint::black_box(inputs_);
        let mut evolutions_: u32 = 0;
        loop {
            fence_on_armv6m();
            let was_state_rest_: __FloatRegion0 = self.region_0;
            let was_state_fill_: __FloatRegion1 = self.region_1;
            let was_state_drain_: __FloatRegion2 = self.region_2;
            let clears_rest_fill_: bool = self.region_0
                == __FloatRegion0::Rest && inputs_.on
                && ({
                    let level = inputs_.level;
                    let low = self.params.low;
                    level < low
                });
            let clears_rest_drain_: bool = self.region_0
                == __FloatRegion0::Rest && inputs_.on
                && ({
                    let level = inputs_.level;
                    let high = self.params.high;
                    level > high
                });
            let clears_fill_rest_: bool = self.region_1
                == __FloatRegion1::Fill
                && (({
                    #[allow(unused_variables)]
                    let level = inputs_.level;
                    #[allow(unused_variables)]
                    let low = self.params.low;
                    level >= low + 2.0
                }) || !inputs_.on);
            let clears_drain_rest_: bool = self.region_2
                == __FloatRegion2::Drain
                && (({
                    #[allow(unused_variables)]
                    let level = inputs_.level;
                    #[allow(unused_variables)]
                    let high = self.params.high;
                    level <= high - 2.0
                }) || !inputs_.on);
            if clears_rest_fill_ || clears_rest_drain_ {
                self.region_0 = __FloatRegion0::NONE;
            }
            if clears_fill_rest_ {
                self.region_1 = __FloatRegion1::NONE;
            }
            if clears_drain_rest_ {
                self.region_2 = __FloatRegion2::NONE;
            }
            if clears_fill_rest_ || clears_drain_rest_ {
                self.region_0 = __FloatRegion0::Rest;
            }
            if clears_rest_fill_ {
                self.region_1 = __FloatRegion1::Fill;
            }
            if clears_rest_drain_ {
                self.region_2 = __FloatRegion2::Drain;
            }
            let mut moves_22__: bool = was_state_rest_
                != self.region_0;
            moves_22__ = moves_22__ || was_state_fill_ != self.region_1;
            moves_22__ = moves_22__ || was_state_drain_ != self.region_2;
            if !moves_22__ {
                self.stable = true;
                break;
            }
            if evolutions_ == 8 {
                self.stable = false;
                self.region_0 = was_state_rest_;
                self.region_1 = was_state_fill_;
                self.region_2 = was_state_drain_;
                break;
            }
            evolutions_ = evolutions_.wrapping_add(1);
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_1 {
            __FloatRegion1::Fill => {
                outputs_.fill = true;
            }
            _ => {}
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_2 {
            __FloatRegion2::Drain => {
                outputs_.drain = true;
            }
            _ => {}
        }
        outputs_
    }
}
impl Float {
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
        steps_: &[FloatStep],
        #[cfg(doc)]
        steps: &[FloatStep],
        #[cfg(not(doc))]
        inputs_: &FloatInputs,
        #[cfg(doc)]
        inputs: &FloatInputs,
    ) -> Result<
        FloatOutputs,
        ForceError<FloatStep>,
    > {
        Possible::Listed(b"\x01\x03\x07\x05\x02\x06\x04")
            .look(<Self as Chart>::STEPS, steps_)?;
        let mut forced0_: Option<__FloatRegion0> = Option::None;
        let mut forced1_: Option<__FloatRegion1> = Option::None;
        let mut forced2_: Option<__FloatRegion2> = Option::None;
        for step_ in steps_ {
            match *step_ {
                FloatStep::Rest => {
                    forced0_ = Option::Some(__FloatRegion0::Rest);
                }
                FloatStep::Fill => {
                    forced1_ = Option::Some(__FloatRegion1::Fill);
                }
                FloatStep::Drain => {
                    forced2_ = Option::Some(__FloatRegion2::Drain);
                }
            }
        }
        let forced0_ = match forced0_ {
            Option::Some(state_) => state_,
            Option::None => __FloatRegion0::NONE,
        };
        let forced1_ = match forced1_ {
            Option::Some(state_) => state_,
            Option::None => __FloatRegion1::NONE,
        };
        let forced2_ = match forced2_ {
            Option::Some(state_) => state_,
            Option::None => __FloatRegion2::NONE,
        };
        Result::Ok({
            let mut outputs_ = const {
                FloatOutputs {
                    fill: false,
                    drain: false,
                }
            };
            self.region_0 = forced0_;
            self.region_1 = forced1_;
            self.region_2 = forced2_;
            let was_state_fill_: __FloatRegion1 = self.region_1;
            let was_state_drain_: __FloatRegion2 = self.region_2;
            self.stable = true;
            let next_fill_: bool = was_state_fill_
                == __FloatRegion1::Fill;
            let next_drain_: bool = was_state_drain_
                == __FloatRegion2::Drain;
            outputs_.fill = next_fill_;
            outputs_.drain = next_drain_;
            outputs_
        })
    }
}
