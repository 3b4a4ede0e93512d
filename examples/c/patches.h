/* The operations on patches and on masks. */
#ifndef PATCHES_H
#define PATCHES_H

#include "array.h"
#include "json.h"
#include "outcome.h"

outcome patches_locate(array *a, json input);
outcome patches_nearest(array *a, json input);
outcome patches_posterior(array *a, json input);
outcome patches_prove(array *a, json input);
outcome patches_distance(array *a, json input);

#endif
