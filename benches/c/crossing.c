// A pedestrian crossing: every step goes on by time.

#include "chart.h"

typedef struct {
    bool request;
} inputs_t;

typedef struct {
    bool red, yellow, green, walk, wait;
} outputs_t;

enum { GREEN, ASKED, YELLOW, CLEAR, WALK, RED_YELLOW, INIT };

typedef struct {
    // When the step was entered, or the longest time ago: so the counter cannot wrap around beside it.
    uint32_t since;
    uint8_t step;
    bool wait;
} chart_t;

// The longest time that a step waits for.
#define LONGEST 10000

static inline bool next(chart_t *c, const inputs_t *i, uint32_t now) {
    uint32_t time = now - c->since;
    if (time > LONGEST) {
        time = LONGEST;
        c->since = now - LONGEST;
    }
    switch (c->step) {
    case GREEN:
        if (!i->request || time < LONGEST) return false;
        c->step = ASKED;
        c->wait = true;
        break;
    case ASKED:
        if (time < 5000) return false;
        c->step = YELLOW;
        break;
    case YELLOW:
        if (time < 3000) return false;
        c->step = CLEAR;
        break;
    case CLEAR:
        if (time < 2000) return false;
        c->step = WALK;
        c->wait = false;
        break;
    case WALK:
        if (time < 8000) return false;
        c->step = RED_YELLOW;
        break;
    case RED_YELLOW:
        if (time < 1000) return false;
        c->step = GREEN;
        break;
    default:
        c->step = GREEN;
    }
    c->since = now;
    return true;
}

static inline void act(const chart_t *c, outputs_t *q) {
    q->red = q->yellow = q->green = q->walk = false;
    q->wait = c->wait;
    switch (c->step) {
    case YELLOW: q->yellow = true; break;
    case CLEAR: q->red = true; break;
    case WALK: q->red = q->walk = true; break;
    case RED_YELLOW: q->red = q->yellow = true; break;
    default: q->green = true;
    }
}

void crossing_sfc_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    next(c, i, now);
    act(c, q);
}

void crossing_grafcet_cycle(chart_t *c, const inputs_t *i, uint32_t now, outputs_t *q) {
    while (next(c, i, now)) {}
    act(c, q);
}
