// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

impl Presses {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &PressesInputs,
        #[cfg(doc)]
        inputs: &PressesInputs,
    ) -> PressesOutputs {
        let outputs_ = PressesOutputs {};
        self.region_0 = self.region_0.unmarked();
        let mut evolutions_left_: u32 = 20;
        loop {
            core::sync::atomic::compiler_fence(
                core::sync::atomic::Ordering::SeqCst,
            );
            #[allow(unused_variables)]
            let before_0_ = self.region_0.state();
            #[allow(unused_variables)]
            let before_1_ = self.region_1;
            #[allow(unused_variables)]
            let before_2_ = self.region_2;
            #[allow(unused_variables)]
            let before_3_ = self.region_3;
            if evolutions_left_ == 0 {
                let mut copy_ = *self;
                if copy_.__evolve(inputs_) {
                    self.region_0 = self.region_0.marked();
                }
                break;
            }
            if !self.__evolve(inputs_) {
                break;
            }
            #[allow(unused_variables)]
            let after_0_ = self.region_0.state();
            #[allow(unused_variables)]
            let after_1_ = self.region_1;
            #[allow(unused_variables)]
            let after_2_ = self.region_2;
            #[allow(unused_variables)]
            let after_3_ = self.region_3;
            evolutions_left_ -= 1;
        }
        outputs_
    }
    /// One evolution; whether it has changed the situation.
    #[inline(never)]
    fn __evolve(&mut self, inputs_: &PressesInputs) -> bool {
        let mut moved_ = false;
        #[allow(unused_variables)]
        let before_0_ = self.region_0.state();
        #[allow(unused_variables)]
        let before_1_ = self.region_1;
        #[allow(unused_variables)]
        let before_2_ = self.region_2;
        #[allow(unused_variables)]
        let before_3_ = self.region_3;
        match self.region_0.state() {
            __PressesRegion0::Wait => {
                if inputs_.start {
                    self.region_0 = __PressesRegion0Mark::of(__PressesRegion0::One);
                    self.region_1 = __PressesRegion1::Two;
                    self.region_2 = __PressesRegion2::Three;
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    self.region_3 = __PressesRegion3::Four;
                    moved_ = true;
                }
            }
            _ => {
                if self.region_0.state() == __PressesRegion0::OneReady
                    && self.region_1 == __PressesRegion1::TwoReady
                    && self.region_2 == __PressesRegion2::ThreeReady
                    && self.region_3 == __PressesRegion3::FourReady
                {
                    self.region_1 = __PressesRegion1::NONE;
                    self.region_2 = __PressesRegion2::NONE;
                    self.region_3 = __PressesRegion3::NONE;
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    self.region_0 = __PressesRegion0Mark::of(__PressesRegion0::Wait);
                    moved_ = true;
                } else {
                    match self.region_0.state() {
                        __PressesRegion0::One => {
                            if inputs_.one_done {
                                self.region_0 = __PressesRegion0Mark::of(
                                    __PressesRegion0::OneReady,
                                );
                                moved_ = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_1 {
                        __PressesRegion1::Two => {
                            if inputs_.two_done {
                                self.region_1 = __PressesRegion1::TwoReady;
                                moved_ = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_2 {
                        __PressesRegion2::Three => {
                            if inputs_.three_done {
                                self.region_2 = __PressesRegion2::ThreeReady;
                                moved_ = true;
                            }
                        }
                        _ => {}
                    }
                    match self.region_3 {
                        __PressesRegion3::Four => {
                            if inputs_.four_done {
                                self.region_3 = __PressesRegion3::FourReady;
                                moved_ = true;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
        moved_
    }
}
