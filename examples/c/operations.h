/* The operations of the protocol: an array and an input to a result. */
#ifndef OPERATIONS_H
#define OPERATIONS_H

#include "array.h"
#include "json.h"
#include "outcome.h"

/* Write the reply with the result if it is ANSWERED, and nothing if it is not. */
outcome operations_run(array *a, json operation, json input);

/* Write the list of their names. */
void operations_put(void);

#endif
