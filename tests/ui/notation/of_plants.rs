use grafcet::grafcet;

grafcet! {
    sfc Chart {
        input a: bool;
        output q: bool;
        initial step A { q; }
        step B;
        A -[a]-> B -[!a]-> A;
    }

    plant Valve {
        fault: stuck, jammed;
        input q: bool;
        output a: bool;
        initial step Shut;
        step Open { a; }
        Shut -[q && !stuck]-> Open -[!q && !jammed]-> Shut;
    }
}

grafcet! {
    sfc Other {
        input a: bool;
        output q: bool;
        initial step A { q; }
        step B;
        A -[a]-> B -[!a]-> A;
    }

    plant {
        input q: bool;
        output a: bool;
        initial step Shut;
        step Open { a; }
        Shut -[q]-> Open -[!q]-> Shut;
    }
}

fn main() {}
