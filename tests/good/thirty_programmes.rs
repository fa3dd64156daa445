use grafcet::grafcet;

grafcet! {
    /// A combi oven: thirty programmes, chosen by a number; each is a branch of its own.
    pub grafcet ThirtyProgrammes {
        input go, stop, done: bool;
        input programme: u8;
        output heat, steam, fan, error: bool;
        output power: u8 = 0;

        initial step Choose;
        step Refuse { error; }
        step End;
        step Boil { heat; power = 10; }
        step Steam { steam; power = 13; }
        step Fry { fan; power = 16; }
        step Roast { heat; fan; power = 19; }
        step Grill { heat; steam; power = 22; }
        step Bake { heat; power = 25; }
        step Thaw { steam; power = 28; }
        step Warm { fan; power = 31; }
        step Keep { heat; fan; power = 34; }
        step Dry { heat; steam; power = 37; }
        step Proof { heat; power = 40; }
        step Smoke { steam; power = 43; }
        step Clean { fan; power = 46; }
        step Rinse { heat; fan; power = 49; }
        step Descale { heat; steam; power = 52; }
        step Cool { heat; power = 55; }
        step Toast { steam; power = 58; }
        step Simmer { fan; power = 61; }
        step Melt { heat; fan; power = 64; }
        step Braise { heat; steam; power = 67; }
        step Poach { heat; power = 70; }
        step Pasteurise { steam; power = 73; }
        step Sterilise { fan; power = 76; }
        step Ferment { heat; fan; power = 79; }
        step Whip { heat; steam; power = 82; }
        step Knead { heat; power = 85; }
        step Mince { steam; power = 88; }
        step Slice { fan; power = 91; }
        step Weigh { heat; fan; power = 94; }
        step Test { heat; steam; power = 97; }

        Choose -[go && programme == 1]-> Boil -[done || stop]-> End;
        Choose -[go && programme == 2]-> Steam -[done || stop]-> End;
        Choose -[go && programme == 3]-> Fry -[done || stop]-> End;
        Choose -[go && programme == 4]-> Roast -[done || stop]-> End;
        Choose -[go && programme == 5]-> Grill -[done || stop]-> End;
        Choose -[go && programme == 6]-> Bake -[done || stop]-> End;
        Choose -[go && programme == 7]-> Thaw -[done || stop]-> End;
        Choose -[go && programme == 8]-> Warm -[done || stop]-> End;
        Choose -[go && programme == 9]-> Keep -[done || stop]-> End;
        Choose -[go && programme == 10]-> Dry -[done || stop]-> End;
        Choose -[go && programme == 11]-> Proof -[done || stop]-> End;
        Choose -[go && programme == 12]-> Smoke -[done || stop]-> End;
        Choose -[go && programme == 13]-> Clean -[done || stop]-> End;
        Choose -[go && programme == 14]-> Rinse -[done || stop]-> End;
        Choose -[go && programme == 15]-> Descale -[done || stop]-> End;
        Choose -[go && programme == 16]-> Cool -[done || stop]-> End;
        Choose -[go && programme == 17]-> Toast -[done || stop]-> End;
        Choose -[go && programme == 18]-> Simmer -[done || stop]-> End;
        Choose -[go && programme == 19]-> Melt -[done || stop]-> End;
        Choose -[go && programme == 20]-> Braise -[done || stop]-> End;
        Choose -[go && programme == 21]-> Poach -[done || stop]-> End;
        Choose -[go && programme == 22]-> Pasteurise -[done || stop]-> End;
        Choose -[go && programme == 23]-> Sterilise -[done || stop]-> End;
        Choose -[go && programme == 24]-> Ferment -[done || stop]-> End;
        Choose -[go && programme == 25]-> Whip -[done || stop]-> End;
        Choose -[go && programme == 26]-> Knead -[done || stop]-> End;
        Choose -[go && programme == 27]-> Mince -[done || stop]-> End;
        Choose -[go && programme == 28]-> Slice -[done || stop]-> End;
        Choose -[go && programme == 29]-> Weigh -[done || stop]-> End;
        Choose -[go && programme == 30]-> Test -[done || stop]-> End;
        Choose -[go && (programme == 0 || programme > 30)]-> Refuse -[stop]-> End;
        End -[!go && !done && !stop]-> Choose;
    }
}
