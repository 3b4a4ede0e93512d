/* Bayes' theorem: how likely each position is, given the probability of each code in each cell. */
#ifndef CHANCES_H
#define CHANCES_H

#include "locate.h"

/* Compute the probabilities of the positions, whose rectangle is put into `e`. `read` is to tell
 * the q chances of an observed cell, which add up to 1. CONTRADICTION if no position is possible. */
typedef void chance_reader(uint32_t cell, double *chances);
outcome posterior(array *a, const patch *p, chance_reader *read, extent *e);

/* The probability of a position, counted row by row, after that. */
double posterior_at(uint32_t k);

#endif
