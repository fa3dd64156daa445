use grafcet::grafcet;

// Two partial grafcets write one variable; that they wait for each other keeps them from doing it at once.
grafcet! {
    grafcet Hand { input take, done, b1, b2: bool; output arm: bool; var n: u8 = 0;
      partial Feeder { initial step F0; step F1 { P1 n = 1; } step F2; F0 -[b1 && n < 9]-> F1 -[Picker::K1.X]-> F2 -[Picker::K3.X]-> F0; }
      partial Picker { initial step K0; step K1 { arm; } step K2 { P1 n = 0; } step K3; K0 -[F1.X && take]-> K1 -[F2.X && done]-> K2 -[b2]-> K3 -[F0.X]-> K0; } }
}
