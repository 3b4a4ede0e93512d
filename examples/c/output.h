/* Replies, gathered in a fixed buffer and written when it is full or when all is said. */
#ifndef OUTPUT_H
#define OUTPUT_H

#include <stddef.h>
#include <stdint.h>

#include "json.h"

void put_bytes(const char *bytes, size_t length);
void put(const char *text);
void put_number(uint64_t number); /* as a string where it is above 2^53 - 1 */
void put_real(double number);
void put_flush(void);

/* A reply begins with the sequence of its request, if it has one. */
void reply_to(json sequence);
void reply_with(const char *kind); /* {"sequence":7,"KIND": */

#endif
