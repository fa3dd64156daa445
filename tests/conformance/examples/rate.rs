use std::collections::BTreeMap;
fn main() {
    for grafcet in [false, true] {
        let mut why: BTreeMap<String, usize> = BTreeMap::new();
        let mut feats: BTreeMap<&str, usize> = BTreeMap::new();
        let (mut ok, mut shown) = (0, 0);
        for seed in 0..300 {
            let r = grafcet_conformance::random::chart(seed, grafcet, 10);
            match grafcet_conformance::chart::resolve(&r.chart) {
                Ok(_) => { ok += 1; for f in r.features { *feats.entry(f).or_default() += 1; } }
                Err(e) => {
                    let e = e.lines().next().unwrap().to_owned();
                    let key = e.rsplit("grafcet::").next().unwrap().chars().take(60).collect::<String>();
                    let n = why.entry(key).or_default(); *n += 1;
                    if *n == 1 && shown < 12 { shown += 1; println!("seed {seed} grafcet {grafcet}: {e}"); }
                }
            }
        }
        println!("grafcet {grafcet}: ok {ok}/300 {why:#?} {feats:?}");
    }
}
