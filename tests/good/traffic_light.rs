use grafcet::grafcet;

grafcet! {
    /// Cars have green until somebody has pressed the button; the request is kept until the walk begins.
    pub grafcet TrafficLight {
        input button: bool;
        output car_green, car_amber, car_red, walk, stay, wait: bool;

        partial Request {
            initial step Nobody;
            step Somebody { wait; }
            Nobody -[rising(button) && !Lights::Walk.X]-> Somebody -[Lights::Walk.X]-> Nobody;
        }

        partial Lights {
            initial step Drive { car_green; stay; }
            step Slow { car_amber; stay; }
            step Clear { car_red; stay; }
            step Walk { car_red; walk; }
            step Leave { car_red; stay; }
            step Ready { car_red; car_amber; stay; }

            Drive -[Request::Somebody.X && 10s/Drive]-> Slow -[3s/Slow]-> Clear -[2s/Clear]-> Walk -[8s/Walk]-> Leave;
            Leave -[4s/Leave]-> Ready -[1s/Ready]-> Drive;
        }
    }
}
