// A packaging machine: an emergency stop above two modes, production within one of them, an outfeed beside it.

#include "chart.h"

typedef struct {
    bool ack, auto_, carton, erected, bottle, closed, out, jog, estop, jam;
} inputs_t;

typedef struct {
    bool alarm, manual, erect, gate, push, close, tape, eject, belt, jammed, lamp;
    uint16_t cartons;
} outputs_t;

// A stop leaves no mode, and from WAIT on the mode is automatic.
enum { STOPPED, MANUAL, WAIT, ERECT, COLLECT, PUSH, CLOSE, TAPE, EJECT };
// Has a meaning in automatic mode.
enum { FREE, MOVE, JAMMED };

typedef struct {
    uint32_t taping_since, moving_since;
    uint16_t cartons;
    uint8_t step, outfeed, bottles;
    // The inputs of the cycle before; on before the first, in which there is no edge.
    bool ack, auto_;
} chart_t;

static inline bool convey(chart_t *c, const inputs_t *i, uint32_t now) {
    switch (c->outfeed) {
    case FREE:
        if (!i->out) return false;
        c->outfeed = MOVE;
        c->moving_since = now;
        return true;
    case MOVE:
        if (i->jam) {
            c->outfeed = JAMMED;
            return true;
        }
        if (i->out || now - c->moving_since < 500) return false;
        c->outfeed = FREE;
        return true;
    default:
        if (i->jam) return false;
        c->outfeed = MOVE;
        c->moving_since = now;
        return true;
    }
}

static inline bool pack(chart_t *c, const inputs_t *i, uint32_t now, bool free) {
    switch (c->step) {
    case WAIT:
        if (!i->carton) return false;
        c->step = ERECT;
        return true;
    case ERECT:
        if (!i->erected) return false;
        c->step = COLLECT;
        return true;
    case COLLECT:
        if (!i->bottle) return false;
        c->bottles++;
        c->step = PUSH;
        return true;
    case PUSH:
        if (i->bottle) return false;
        if (c->bottles < 3) {
            c->step = COLLECT;
        } else {
            c->bottles = 0;
            c->step = CLOSE;
        }
        return true;
    case CLOSE:
        if (!i->closed) return false;
        c->step = TAPE;
        c->taping_since = now;
        return true;
    case TAPE:
        if (now - c->taping_since < 1000) return false;
        c->cartons++;
        c->step = EJECT;
        return true;
    case EJECT:
        if (i->carton || !free) return false;
        c->step = WAIT;
        return true;
    }
    return false;
}

// Automatic mode: evolutions until nothing moves.
static inline void run(chart_t *c, const inputs_t *i, uint32_t now) {
    for (;;) {
        if (c->step == WAIT && !i->auto_) {
            c->step = MANUAL;
            return;
        }
        bool free = c->outfeed == FREE, conveyed = convey(c, i, now);
        if (!pack(c, i, now, free) && !conveyed)
            return;
    }
}

static inline void act(const chart_t *c, const inputs_t *i, outputs_t *q) {
    q->alarm = q->manual = q->erect = q->gate = q->push = q->close = false;
    q->tape = q->eject = q->belt = q->jammed = q->lamp = false;
    q->cartons = c->cartons;
    switch (c->step) {
    case STOPPED: q->alarm = true; return;
    case MANUAL: q->manual = true; q->belt = i->jog; return;
    case WAIT: q->lamp = true; break;
    case ERECT: q->erect = true; break;
    case COLLECT: q->gate = true; break;
    case PUSH: q->push = true; break;
    case CLOSE: q->close = true; break;
    case TAPE: q->tape = q->close = true; break;
    case EJECT: q->eject = true; break;
    }
    q->belt = c->outfeed == MOVE;
    q->jammed = c->outfeed == JAMMED;
}

// IEC 60848: times and sensors that are on or off end every search. The stop is asked once a cycle.
void packer_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    bool acked = i->ack && !c->ack, switched = i->auto_ && !c->auto_;
    c->ack = i->ack;
    c->auto_ = i->auto_;
    if (i->estop) {
        c->step = STOPPED;
    } else if (c->step == STOPPED) {
        if (acked)
            c->step = MANUAL;
    } else if (c->step == MANUAL) {
        if (switched) {
            c->step = WAIT;
            c->outfeed = FREE;
            c->bottles = 0;
            run(c, i, now);
        }
    } else {
        run(c, i, now);
    }
    act(c, i, q);
}
