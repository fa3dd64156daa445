// Recorded by `cargo xtask bless`: the cycle of the chart beside it, without the facade's path.

enum __HandlingRegion0 {
    Idle,
    Heat,
    Hold,
    INIT,
}
enum __HandlingRegion1 {
    Stir,
    Rest,
    NONE,
}
enum __HandlingRegion2 {
    Vent,
    Shut,
    NONE,
}
impl Handling {
    /// One cycle: evaluates the transition conditions on the inputs, clears, acts, and returns the outputs of the new
    /// situation.
    fn cycle(
        &mut self,
        #[cfg(not(doc))]
        inputs_: &HandlingInputs,
        #[cfg(doc)]
        inputs: &HandlingInputs,
    ) -> HandlingOutputs {
        let mut outputs_ = const {
            HandlingOutputs {
                heater: false,
                stirrer: false,
                vent: false,
            }
        };
        let edge1_now_: bool = {
            let temp = inputs_.temp;
            temp >= 600
        };
        match self.region_0 {
            __HandlingRegion0::INIT => {
                self.region_0 = __HandlingRegion0::Idle;
            }
            __HandlingRegion0::Idle => {
                if !self.edge0_before && inputs_.go {
                    self.region_0 = __HandlingRegion0::Heat;
                    self.region_1 = __HandlingRegion1::Stir;
                    self.region_2 = __HandlingRegion2::Vent;
                    self.edge3_before = false;
                    self.edge4_before = false;
                } else {
                    self.edge3_before = false;
                    self.edge4_before = false;
                }
            }
            _ => {
                let edge3_now_: bool = self.region_0
                    == __HandlingRegion0::Hold;
                if self.region_0 == __HandlingRegion0::Hold
                    && self.region_1 == __HandlingRegion1::Rest
                    && self.region_2 == __HandlingRegion2::Shut
                    && !(self.edge1_before && !edge1_now_)
                    && !(!self.edge3_before && edge3_now_ || inputs_.a) && !inputs_.b
                    && inputs_.ok
                {
                    self.edge2_before = false;
                    self.edge4_before = true;
                    self.region_1 = __HandlingRegion1::NONE;
                    self.region_2 = __HandlingRegion2::NONE;
                    self.region_0 = __HandlingRegion0::Idle;
                } else {
                    let edge4_now_: bool = self.region_1
                        == __HandlingRegion1::Rest;
                    match self.region_2 {
                        __HandlingRegion2::Vent => {
                            if !self.edge4_before && edge4_now_ {
                                self.region_2 = __HandlingRegion2::Shut;
                            }
                        }
                        __HandlingRegion2::Shut => {
                            if inputs_.b {
                                self.region_2 = __HandlingRegion2::Vent;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    self.edge4_before = edge4_now_;
                    let edge2_now_: bool = self.region_0
                        == __HandlingRegion0::Heat;
                    match self.region_1 {
                        __HandlingRegion1::Stir => {
                            if !self.edge2_before && edge2_now_ {
                                self.region_1 = __HandlingRegion1::Rest;
                            }
                        }
                        __HandlingRegion1::Rest => {
                            if !self.edge3_before && edge3_now_ || inputs_.a {
                                self.region_1 = __HandlingRegion1::Stir;
                            }
                        }
                        _ => {}
                    }
                    core::sync::atomic::compiler_fence(
                        core::sync::atomic::Ordering::SeqCst,
                    );
                    self.edge2_before = edge2_now_;
                    match self.region_0 {
                        __HandlingRegion0::Heat => {
                            if !self.edge1_before && edge1_now_ {
                                self.region_0 = __HandlingRegion0::Hold;
                            }
                        }
                        __HandlingRegion0::Hold => {
                            if self.edge1_before && !edge1_now_ {
                                self.region_0 = __HandlingRegion0::Heat;
                            }
                        }
                        _ => {}
                    }
                }
                self.edge3_before = edge3_now_;
            }
        }
        self.edge0_before = inputs_.go;
        self.edge1_before = edge1_now_;
        core::sync::atomic::compiler_fence(
            core::sync::atomic::Ordering::SeqCst,
        );
        match self.region_0 {
            __HandlingRegion0::Heat => {
                outputs_.heater = true;
            }
            __HandlingRegion0::Hold => {
                outputs_.heater = {
                    let temp = inputs_.temp;
                    temp < 500
                };
            }
            _ => {}
        }
        outputs_.stirrer = self.region_1 == __HandlingRegion1::Stir;
        outputs_.vent = self.region_2 == __HandlingRegion2::Vent;
        outputs_
    }
}
