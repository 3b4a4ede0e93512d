/* From a profile to its array. */
#ifndef PROFILE_H
#define PROFILE_H

#include "array.h"
#include "json.h"
#include "outcome.h"

/* IMPOSSIBLE if there is no such array, INVALID if it is no profile, TOO_LARGE if the array may
 * exist and does not fit here. */
outcome profile_read(array *a, json profile);

#endif
