use grafcet::grafcet;

grafcet! {
    sfc Mixer {
        input S, type: bool;
        output x: bool;

        initial step INIT { N x; }
        step match;

        INIT -[Self: S]-> match -[S]-> INIT;
    }
}

fn main() {
    let mut mixer = Mixer::new();
    let _ = mixer.cycle(&MixerInputs::default());
}
