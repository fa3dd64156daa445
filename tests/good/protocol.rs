use grafcet::grafcet;

grafcet! {
    /// A serial frame, byte by byte, as a state machine with thirty branches and no parallel one.
    pub sfc Protocol {
        input ready: bool;
        input byte: u8;
        output ack, nak, busy: bool;
        var length, seen, sum: u8 = 0;
        param patience: time = 50ms;

        initial step Listen;
        step Sync;
        step Kind;
        step ReadHead { N busy; P1 { seen = 0; sum = 0; } }
        step WriteHead { N busy; P1 { seen = 0; sum = 0; } }
        step EraseHead { N busy; P1 { seen = 0; sum = 0; } }
        step ReadData { N busy; P1 { seen = seen.wrapping_add(1); sum = sum.wrapping_add(byte); } }
        step WriteData { N busy; P1 { seen = seen.wrapping_add(1); sum = sum.wrapping_add(byte); } }
        step Between { N busy; }
        step Check { N busy; P1 { length = byte; } }
        step Good { N ack; }
        step Bad { N nak; }
        step Late { N nak; }

        Listen -[ready && byte == 0x55]-> Sync;
        Sync -[ready && byte == 0xAA]-> Kind;
        Sync -[ready && byte == 0x55]-> Listen;
        Sync -[ready]-> Bad;
        Sync -[patience/Sync]-> Late;
        Kind -[ready && byte == 1]-> ReadHead;
        Kind -[ready && byte == 2]-> WriteHead;
        Kind -[ready && byte == 3]-> EraseHead;
        Kind -[ready && byte > 3]-> Bad;
        Kind -[patience/Kind]-> Late;
        ReadHead -[ready && byte == 0]-> Check;
        ReadHead -[ready && byte < 16]-> ReadData;
        ReadHead -[ready]-> Bad;
        ReadHead -[patience/ReadHead]-> Late;
        WriteHead -[ready && byte == 0]-> Bad;
        WriteHead -[ready && byte < 32]-> WriteData;
        WriteHead -[ready]-> Bad;
        WriteHead -[patience/WriteHead]-> Late;
        EraseHead -[ready && byte == 0xFF]-> Check;
        EraseHead -[ready]-> Bad;
        EraseHead -[patience/EraseHead]-> Late;
        ReadData -[!ready]-> Between;
        ReadData -[patience/ReadData]-> Late;
        WriteData -[!ready]-> Between;
        WriteData -[patience/WriteData]-> Late;
        Between -[ready && seen >= length]-> Check;
        Between -[ready]-> WriteData;
        Between -[patience/Between]-> Late;
        Check -[!ready && sum == length]-> Good;
        Check -[!ready]-> Bad;
        Check -[patience/Check]-> Late;
        Good -[!ready]-> Listen;
        Bad -[!ready]-> Listen;
        Late -[ready]-> Listen;
    }
}
