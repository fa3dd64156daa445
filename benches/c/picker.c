// Pick and place: every movement is watched.

#include "chart.h"

typedef struct {
    bool start, part, left, right, up, down, vacuum, ack;
} inputs_t;

typedef struct {
    bool ready, go_left, go_right, lower, suck, blow, alarm;
    uint8_t code;
} outputs_t;

// The faults follow each other as their codes do.
enum {
    HOME, WAIT, LOWER_PICK, GRIP, RAISE_PICK, CARRY, LOWER_PLACE, RELEASE, RAISE_PLACE, BACK, RECOVER,
    NOT_MOVED, NOT_LOWERED, NOT_GRIPPED, NOT_RAISED, LOST, INIT,
};

typedef struct {
    // The watchdogs end every step that has one; only an `ack` of 49.7 days makes the counter wrap, in RECOVER.
    uint32_t since;
    uint8_t step, tries;
    bool suck;
} chart_t;

// One evolution; whether anything has moved.
static inline bool next(chart_t *c, const inputs_t *i, uint32_t now) {
    uint32_t time = now - c->since;
    uint8_t step;
    switch (c->step) {
    case HOME:
        if (i->left && i->up) step = WAIT;
        else if (time >= 4000) step = NOT_MOVED;
        else return false;
        break;
    case WAIT: if (!i->start || !i->part) return false; step = LOWER_PICK; break;
    case LOWER_PICK:
        if (i->down) {
            c->suck = true;
            c->tries++;
            step = GRIP;
        } else if (time >= 1000) {
            step = NOT_LOWERED;
        } else {
            return false;
        }
        break;
    case GRIP:
        if (i->vacuum) {
            if (time < 300) return false;
            step = RAISE_PICK;
        } else {
            if (time < 800) return false;
            if (c->tries < 3) {
                step = LOWER_PICK;
            } else {
                c->suck = false;
                c->tries = 0;
                step = NOT_GRIPPED;
            }
        }
        break;
    case RAISE_PICK:
        if (i->up) step = CARRY;
        else if (time >= 500) step = NOT_RAISED;
        else return false;
        break;
    case CARRY:
        if (i->right) {
            step = LOWER_PLACE;
        } else if (i->vacuum) {
            if (time < 500) return false;
            step = NOT_MOVED;
        } else {
            if (time < 200) return false;
            c->suck = false;
            c->tries = 0;
            step = LOST;
        }
        break;
    case LOWER_PLACE:
        if (i->down) {
            c->suck = false;
            c->tries = 0;
            step = RELEASE;
        } else if (time >= 500) {
            step = NOT_LOWERED;
        } else {
            return false;
        }
        break;
    case RELEASE: if (i->vacuum || time < 200) return false; step = RAISE_PLACE; break;
    case RAISE_PLACE:
        if (i->up) step = BACK;
        else if (time >= 500) step = NOT_RAISED;
        else return false;
        break;
    case BACK:
        if (i->left) step = WAIT;
        else if (time >= 500) step = NOT_MOVED;
        else return false;
        break;
    case RECOVER: if (i->ack || time < 1000) return false; step = HOME; break;
    case INIT: step = HOME; break;
    default:
        if (!i->ack) return false;
        c->suck = false;
        step = RECOVER;
    }
    c->step = step;
    c->since = now;
    return true;
}

static inline void act(const chart_t *c, outputs_t *q) {
    q->ready = q->go_left = q->go_right = q->lower = q->blow = q->alarm = false;
    q->suck = c->suck;
    q->code = 0;
    switch (c->step) {
    case HOME: case BACK: q->go_left = true; break;
    case WAIT: q->ready = true; break;
    case LOWER_PICK: case LOWER_PLACE: q->lower = true; break;
    case CARRY: q->go_right = true; break;
    case RELEASE: q->blow = true; break;
    case NOT_MOVED: case NOT_LOWERED: case NOT_GRIPPED: case NOT_RAISED: case LOST:
        q->alarm = true;
        q->code = c->step - RECOVER;
        break;
    }
}

// IEC 61131-3: one evolution per cycle; that of the first activates the initial step.
void picker_sfc_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    next(c, i, now);
    act(c, q);
}

// IEC 60848: evolutions until nothing moves; the times end every search.
void picker_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    while (next(c, i, now)) {}
    act(c, q);
}
