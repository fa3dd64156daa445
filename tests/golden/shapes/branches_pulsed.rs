// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __CountingRegion0 {
    Idle,
    A0,
    A1,
    A2,
    A3,
    AE,
    INIT,
}
enum __CountingRegion1 {
    B0,
    B1,
    B2,
    B3,
    BE,
    NONE,
}
impl Counting {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &CountingInputs,
        #[cfg(doc)]
        inputs: &CountingInputs,
    ) -> CountingOutputs {
        let mut outputs_ = CountingOutputs { lamp: false };
        let mut entered_a0__: bool = false;
        let mut entered_a1__: bool = false;
        let mut entered_a2__: bool = false;
        let mut entered_a3__: bool = false;
        let mut entered_b0__: bool = false;
        let mut entered_b1__: bool = false;
        let mut entered_b2__: bool = false;
        let mut entered_b3__: bool = false;
        match self.region_0 {
            __CountingRegion0::INIT => {
                self.region_0 = __CountingRegion0::Idle;
            }
            __CountingRegion0::Idle => {
                if inputs_.go {
                    entered_a0__ = true;
                    entered_b0__ = true;
                    self.region_0 = __CountingRegion0::A0;
                    self.region_1 = __CountingRegion1::B0;
                }
            }
            _ => {
                if self.region_0 == __CountingRegion0::AE
                    && self.region_1 == __CountingRegion1::BE && inputs_.c
                {
                    self.region_1 = __CountingRegion1::NONE;
                    self.region_0 = __CountingRegion0::Idle;
                } else {
                    match self.region_0 {
                        __CountingRegion0::A0 => {
                            if inputs_.a {
                                entered_a1__ = true;
                                self.region_0 = __CountingRegion0::A1;
                            }
                        }
                        __CountingRegion0::A1 => {
                            if inputs_.b {
                                entered_a2__ = true;
                                self.region_0 = __CountingRegion0::A2;
                            }
                        }
                        __CountingRegion0::A2 => {
                            if inputs_.c {
                                entered_a3__ = true;
                                self.region_0 = __CountingRegion0::A3;
                            }
                        }
                        __CountingRegion0::A3 => {
                            if inputs_.a {
                                self.region_0 = __CountingRegion0::AE;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    match self.region_1 {
                        __CountingRegion1::B0 => {
                            if inputs_.b {
                                entered_b1__ = true;
                                self.region_1 = __CountingRegion1::B1;
                            }
                        }
                        __CountingRegion1::B1 => {
                            if inputs_.c {
                                entered_b2__ = true;
                                self.region_1 = __CountingRegion1::B2;
                            }
                        }
                        __CountingRegion1::B2 => {
                            if inputs_.a {
                                entered_b3__ = true;
                                self.region_1 = __CountingRegion1::B3;
                            }
                        }
                        __CountingRegion1::B3 => {
                            if inputs_.b {
                                self.region_1 = __CountingRegion1::BE;
                            }
                        }
                        _ => {}
                    }
                }
            }
        }
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        if entered_a0__ {
            self.n = {
                let n = self.n;
                n % 90 + 1
            };
        } else {
            if self.was_q_a0_1_ {
                self.n = {
                    let n = self.n;
                    n % 90 + 1
                };
            }
        }
        if entered_a1__ {
            self.n = {
                let n = self.n;
                n % 80 + 2
            };
        } else {
            if self.was_q_a1_2_ {
                self.n = {
                    let n = self.n;
                    n % 80 + 2
                };
            }
        }
        if entered_a2__ {
            self.n = {
                let n = self.n;
                n % 70 + 3
            };
        } else {
            if self.was_q_a2_3_ {
                self.n = {
                    let n = self.n;
                    n % 70 + 3
                };
            }
        }
        if entered_a3__ {
            self.n = {
                let n = self.n;
                n % 60 + 4
            };
        } else {
            if self.was_q_a3_4_ {
                self.n = {
                    let n = self.n;
                    n % 60 + 4
                };
            }
        }
        if entered_b0__ {
            self.n = {
                let n = self.n;
                n % 50 + 5
            };
        } else {
            if self.was_q_b0_5_ {
                self.n = {
                    let n = self.n;
                    n % 50 + 5
                };
            }
        }
        if entered_b1__ {
            self.n = {
                let n = self.n;
                n % 40 + 6
            };
        } else {
            if self.was_q_b1_6_ {
                self.n = {
                    let n = self.n;
                    n % 40 + 6
                };
            }
        }
        if entered_b2__ {
            self.n = {
                let n = self.n;
                n % 30 + 7
            };
        } else {
            if self.was_q_b2_7_ {
                self.n = {
                    let n = self.n;
                    n % 30 + 7
                };
            }
        }
        if entered_b3__ {
            self.n = {
                let n = self.n;
                n % 20 + 8
            };
        } else {
            if self.was_q_b3_8_ {
                self.n = {
                    let n = self.n;
                    n % 20 + 8
                };
            }
        }
        self.was_q_a0_1_ = entered_a0__;
        self.was_q_a1_2_ = entered_a1__;
        self.was_q_a2_3_ = entered_a2__;
        self.was_q_a3_4_ = entered_a3__;
        self.was_q_b0_5_ = entered_b0__;
        self.was_q_b1_6_ = entered_b1__;
        self.was_q_b2_7_ = entered_b2__;
        self.was_q_b3_8_ = entered_b3__;
        outputs_.lamp = self.region_0 == __CountingRegion0::Idle;
        outputs_
    }
}
