use grafcet::grafcet;

// Words of the notation that need no protection, and keywords of Rust in their raw form.
grafcet! {
    sfc Mixer {
        input on, step, time, s, r#type: bool;
        output x: bool;

        initial step Init { N x; }
        step r#match;

        Init -[start: on && s]-> r#match -[step || time || r#type]-> Init;
    }
}

fn main() {
    let mut mixer = Mixer::new();
    let _ = mixer.cycle(&MixerInputs::default());
}
