// A machining cell: an emergency stop above two modes, production within one of them.

#include "chart.h"

typedef struct {
    bool ack, auto_, part, clamped, drilled, stamped, estop;
} inputs_t;

typedef struct {
    bool conveyor, clamp, drill, stamp, alarm;
    uint16_t parts;
} outputs_t;

enum { READY, STOPPED, RESTART };
// OFF after an emergency stop.
enum { OFF, MANUAL, AUTO };
// In WORK the part is drilled and stamped.
enum { FEED, CLOSE, CLOSED, WORK, RELEASE, DELIVER };

typedef struct {
    uint16_t parts;
    // The production has a meaning in automatic mode, what is done in WORK.
    uint8_t safety, mode, production;
    bool drilled, stamped;
    bool clamp;
    // The inputs of the cycle before; on before the first, in which there is no edge.
    bool ack, auto_;
} cell_t;

static inline bool produce(cell_t *c, const inputs_t *i) {
    switch (c->production) {
    case FEED:
        if (i->part) {
            c->production = CLOSE;
            c->clamp = true;
            return true;
        }
        if (i->auto_) return false;
        c->mode = MANUAL;
        c->clamp = false;
        return true;
    case CLOSE:
        if (!i->clamped) return false;
        c->production = CLOSED;
        return true;
    case CLOSED:
        c->production = WORK;
        c->drilled = c->stamped = false;
        return true;
    case WORK:
        if (c->drilled && c->stamped) {
            c->production = RELEASE;
            c->clamp = false;
            c->parts++;
            return true;
        }
        bool drilled = c->drilled | i->drilled, stamped = c->stamped | i->stamped;
        bool moved = drilled != c->drilled || stamped != c->stamped;
        c->drilled = drilled;
        c->stamped = stamped;
        return moved;
    case RELEASE:
        if (i->clamped) return false;
        c->production = DELIVER;
        return true;
    case DELIVER:
        if (i->part) return false;
        c->production = FEED;
        return true;
    }
    return false;
}

// One evolution; whether anything has moved.
static inline bool next(cell_t *c, const inputs_t *i, bool acked, bool switched) {
    switch (c->safety) {
    case READY:
        if (!i->estop) break;
        c->safety = STOPPED;
        c->mode = OFF;
        return true;
    case STOPPED:
        if (i->estop || !acked) return false;
        c->safety = RESTART;
        c->mode = MANUAL;
        c->clamp = false;
        return true;
    case RESTART:
        c->safety = READY;
        return true;
    }
    switch (c->mode) {
    case MANUAL:
        if (!switched) return false;
        c->mode = AUTO;
        c->production = FEED;
        return true;
    case AUTO:
        return produce(c, i);
    }
    return false;
}

// IEC 60848: evolutions until nothing moves. A part is clamped or not, so every search ends.
void cell_grafcet_cycle(cell_t *c, const inputs_t *i, outputs_t *q) {
    bool acked = i->ack && !c->ack, switched = i->auto_ && !c->auto_;
    c->ack = i->ack;
    c->auto_ = i->auto_;
    // An edge is one for the first evolution.
    while (next(c, i, acked, switched)) acked = switched = false;
    uint8_t production = c->mode == AUTO ? c->production : CLOSE;
    q->conveyor = production == FEED || production == DELIVER;
    q->clamp = c->clamp;
    q->drill = production == WORK && !c->drilled;
    q->stamp = production == WORK && !c->stamped;
    q->alarm = c->safety == STOPPED;
    q->parts = c->parts;
}
