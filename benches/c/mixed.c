// A filling station: two sections of two parallel branches each, times, stored outputs.

#include "chart.h"

typedef struct {
    bool start, part, clamped, hot, filled, weighed, good, capped, printed, stuck, gone;
} inputs_t;

typedef struct {
    bool ready, busy, belt, heater, valve, pump, stirrer, eject, alarm, capper, press, printer, labeler;
} outputs_t;

// FILL and CLOSE are the parallel sections.
enum { IDLE, LOAD, CLAMP, FILL, WEIGH, REJECT, CLOSE, UNCLAMP, DELIVER, INIT };
enum { HEAT, HOLD, HEATED, CAP, PRESS, CAPPED };
enum { OPEN, DOSE, SETTLE, DOSED, PRINT, LABEL, LABELLED };

typedef struct {
    // When the left branch, or outside of the sections the main one, was entered with a time to wait for.
    uint32_t left_since, right_since;
    // The branches have a meaning in the parallel sections.
    uint8_t main, left, right;
    bool busy, valve, alarm;
} chart_t;

static inline bool next_left(chart_t *c, const inputs_t *i, uint32_t now) {
    switch (c->left) {
    case HEAT:
        if (!i->hot) return false;
        c->left = HOLD;
        c->left_since = now;
        return true;
    case HOLD:
        if (now - c->left_since < 5000) return false;
        c->left = HEATED;
        return true;
    case CAP:
        if (!i->capped) return false;
        c->left = PRESS;
        c->left_since = now;
        return true;
    case PRESS:
        if (now - c->left_since < 3000) return false;
        c->left = CAPPED;
        return true;
    }
    return false;
}

static inline bool next_right(chart_t *c, const inputs_t *i, uint32_t now) {
    switch (c->right) {
    case OPEN:
        if (now - c->right_since < 1000) return false;
        c->right = DOSE;
        c->right_since = now;
        return true;
    case DOSE:
        if (!i->filled) return false;
        c->right = SETTLE;
        c->right_since = now;
        return true;
    case SETTLE:
        if (now - c->right_since < 2000) return false;
        c->right = DOSED;
        c->valve = false;
        return true;
    case PRINT:
        if (!i->printed) return false;
        c->right = LABEL;
        return true;
    case LABEL:
        if (i->stuck) return false;
        c->right = LABELLED;
        return true;
    }
    return false;
}

// One evolution; whether anything has moved.
static inline bool next(chart_t *c, const inputs_t *i, uint32_t now) {
    switch (c->main) {
    case INIT:
        c->main = IDLE;
        return true;
    case IDLE:
        if (!i->start) return false;
        c->main = LOAD;
        c->busy = true;
        return true;
    case LOAD:
        if (!i->part) return false;
        c->main = CLAMP;
        c->alarm = false;
        return true;
    case CLAMP:
        if (!i->clamped) return false;
        c->main = FILL;
        c->left = HEAT;
        c->right = OPEN;
        c->right_since = now;
        c->valve = true;
        return true;
    case FILL:
        if (c->left == HEATED && c->right == DOSED) {
            c->main = WEIGH;
            return true;
        }
        break;
    case WEIGH:
        if (!i->weighed) return false;
        if (i->good) {
            c->main = CLOSE;
            c->left = CAP;
            c->right = PRINT;
            c->right_since = now;
        } else {
            c->main = REJECT;
            c->left_since = now;
            c->alarm = true;
        }
        return true;
    case REJECT:
        if (!i->gone && now - c->left_since < 10000) return false;
        c->main = IDLE;
        c->busy = false;
        return true;
    case CLOSE:
        if (c->left == CAPPED && c->right == LABELLED) {
            c->main = UNCLAMP;
            return true;
        }
        break;
    case UNCLAMP:
        if (i->clamped) return false;
        c->main = DELIVER;
        return true;
    case DELIVER:
        if (!i->gone) return false;
        c->main = IDLE;
        c->busy = false;
        return true;
    }
    bool moved = next_left(c, i, now);
    return next_right(c, i, now) || moved;
}

static inline void act(const chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    q->ready = q->belt = q->heater = q->pump = q->stirrer = q->eject = false;
    q->capper = q->press = q->printer = q->labeler = false;
    q->busy = c->busy;
    q->valve = c->valve;
    q->alarm = c->alarm;
    switch (c->main) {
    case IDLE: q->ready = true; return;
    case LOAD: case DELIVER: q->belt = true; return;
    case REJECT: q->eject = true; return;
    case FILL: case CLOSE: break;
    default: return;
    }
    switch (c->left) {
    case HEAT: q->heater = true; break;
    case HOLD: q->heater = !i->hot; break;
    case CAP: q->capper = true; break;
    case PRESS: q->press = true; break;
    }
    switch (c->right) {
    case DOSE: q->pump = true; q->stirrer = now - c->right_since >= 500; break;
    case SETTLE: q->stirrer = true; break;
    case PRINT: q->printer = now - c->right_since < 1000; break;
    case LABEL: q->labeler = true; break;
    }
}

// IEC 61131-3: one evolution per cycle, none in the first.
void mixed_sfc_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    next(c, i, now);
    act(c, i, now, q);
}

// IEC 60848: evolutions until nothing moves; the times end every search.
void mixed_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    while (next(c, i, now)) {}
    act(c, i, now, q);
}
