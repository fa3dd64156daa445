// What the charts share.

#include <stdbool.h>
#include <stdint.h>
