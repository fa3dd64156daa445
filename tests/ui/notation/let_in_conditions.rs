use grafcet::grafcet;

grafcet! {
    sfc Conditions {
        input a: bool;
        input n: Option<u8>;
        output q: bool;
        let c = let None = n;
        initial step A { q if let Some(2) = n; }
        step B;
        A -[let Some(x) = n && x > 3]-> B -[c || rising(let Some(7) = n)]-> A;
        A -[a && !(let Some(4) = n)]-> B -[if let Some(x) = n && x > 3 { let y = 3; x > y } else { a }]-> A;
        never let Some(3) = n;
    }
}

grafcet! {
    grafcet Values {
        input a: bool;
        input n: Option<u8>;
        output q: bool = let Some(1) = Some(2);
        output r: bool;
        var v: bool;
        action go(on: bool);
        initial step A { r = let Some(1) = n; }
        step B { P1 v = let Some(2) = n; N go(let Some(3) = n); S q; on let Some(4) = n v = true; }
        step C { P1 { v = (let Some(5) = n); if let Some(x) = n && let 3.. = x { v = false; } } }
        A -[v]-> B -[r]-> C -[a]-> A;
    }
}

fn main() {
    let _ = (Conditions::new(), Values::new());
}
