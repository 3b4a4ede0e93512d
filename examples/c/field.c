#include "field.h"

#include <string.h>

#include "factors.h"

static bool prime_power(field *f, uint64_t q)
{
    if (q < 2 || q > 256)
        return false;
    f->q = (unsigned)q;
    for (f->p = 2; f->q % f->p != 0; f->p++)
        ;
    unsigned power = f->p;
    for (f->m = 1; power < f->q; f->m++)
        power *= f->p;
    return power == f->q;
}

static void digits_of(const field *f, unsigned code, unsigned *digits)
{
    for (unsigned k = 0; k < f->m; k++, code /= f->p)
        digits[k] = code % f->p;
}

static uint8_t code_of(const field *f, const unsigned *digits)
{
    unsigned code = 0;
    for (unsigned k = f->m; k-- > 0;)
        code = code * f->p + digits[k] % f->p;
    return (uint8_t)code;
}

/* By the definition: multiply the polynomials, then take away multiples of the modulus. */
static uint8_t product(const field *f, uint8_t a, uint8_t b)
{
    unsigned x[8], y[8], z[16] = {0};
    digits_of(f, a, x);
    digits_of(f, b, y);
    for (unsigned i = 0; i < f->m; i++)
        for (unsigned j = 0; j < f->m; j++)
            z[i + j] = (z[i + j] + x[i] * y[j]) % f->p;
    for (unsigned top = 2 * f->m - 2; top >= f->m; top--)
        for (unsigned k = 0; k < f->m; k++)
            z[top - f->m + k] += z[top] % f->p * (f->p - f->modulus[k]);
    return code_of(f, z);
}

/* Whether the powers of g are all elements but 0. Then these have inverses, so that the modulus is
 * irreducible; and if it is, there is such a g. */
static bool generates(field *f, uint8_t g)
{
    uint8_t power = 1;
    for (unsigned i = 0; i < f->q - 1; i++) {
        if (i > 0 && power <= 1)
            return false;
        f->exp[i] = f->exp[i + f->q - 1] = power;
        f->log[power] = (uint8_t)i;
        power = product(f, power, g);
    }
    return power == 1;
}

bool field_make(field *f, uint64_t q, const uint64_t *modulus, unsigned coefficients)
{
    if (!prime_power(f, q) || coefficients != f->m + 1 || modulus[f->m] != 1)
        return false;
    for (unsigned k = 0; k <= f->m; k++) {
        if (modulus[k] >= f->p)
            return false;
        f->modulus[k] = (unsigned)modulus[k];
    }
    for (unsigned g = 1; g < f->q; g++)
        if (generates(f, (uint8_t)g))
            return true;
    return false;
}

uint8_t field_add(const field *f, uint8_t a, uint8_t b)
{
    if (f->p == 2)
        return a ^ b;
    unsigned x[8], y[8];
    digits_of(f, a, x);
    digits_of(f, b, y);
    for (unsigned k = 0; k < f->m; k++)
        x[k] += y[k];
    return code_of(f, x);
}

uint8_t field_negate(const field *f, uint8_t a)
{
    if (f->p == 2)
        return a;
    unsigned x[8];
    digits_of(f, a, x);
    for (unsigned k = 0; k < f->m; k++)
        x[k] = f->p - x[k];
    return code_of(f, x);
}

uint8_t field_multiply(const field *f, uint8_t a, uint8_t b)
{
    return a == 0 || b == 0 ? 0 : f->exp[f->log[a] + f->log[b]];
}

uint8_t field_inverse(const field *f, uint8_t a)
{
    return f->exp[f->q - 1 - f->log[a]];
}

/* a + a^p + ... + a^(p^(m-1)) */
uint8_t field_trace(const field *f, uint8_t a)
{
    uint8_t total = 0;
    for (unsigned k = 0; k < f->m; k++) {
        total = field_add(f, total, a);
        a = a == 0 ? 0 : f->exp[f->log[a] * f->p % (f->q - 1)];
    }
    return total;
}

uint64_t field_period(const field *f, unsigned degree)
{
    uint64_t power = 1;
    for (unsigned k = 0; k < degree; k++) {
        if (power > ((uint64_t)1 << 63) / f->q)
            return 0;
        power *= f->q;
    }
    return power < (uint64_t)1 << 63 ? power : 0;
}

/* Take the multiple of h away that makes the coefficient of x^top zero. */
static void reduce(const field *f, uint8_t *c, unsigned top, const polynomial *h)
{
    uint8_t factor = field_negate(f, c[top]);
    uint8_t *low = c + top - h->degree;
    for (unsigned k = 0; factor != 0 && k < h->degree; k++)
        low[k] = field_add(f, low[k], field_multiply(f, factor, h->c[k]));
}

/* Whether x^exponent = 1 modulo h. */
static bool is_one(const field *f, uint64_t exponent, const polynomial *h)
{
    uint8_t power[MAX_DEGREE + 1] = {1}, square[2 * MAX_DEGREE + 1];
    unsigned n = h->degree;
    int bit = 63;
    while (bit > 0 && exponent >> bit == 0)
        bit--;
    for (; bit >= 0; bit--) {
        memset(square, 0, sizeof square);
        for (unsigned i = 0; i < n; i++)
            for (unsigned j = 0; power[i] != 0 && j < n; j++)
                square[i + j] =
                    field_add(f, square[i + j], field_multiply(f, power[i], power[j]));
        if (exponent >> bit & 1) {
            memmove(square + 1, square, sizeof square - 1);
            square[0] = 0;
        }
        for (unsigned top = 2 * n - 1; top >= n; top--)
            reduce(f, square, top, h);
        memcpy(power, square, n);
    }
    for (unsigned k = 1; k < n; k++)
        if (power[k] != 0)
            return false;
    return power[0] == 1;
}

bool polynomial_is_primitive(const field *f, const polynomial *h)
{
    uint64_t primes[MAX_FACTORS], order = field_period(f, h->degree) - 1;
    if (h->degree == 0 || h->c[h->degree] != 1 || h->c[0] == 0 || !is_one(f, order, h))
        return false;
    int count = prime_factors(order, primes);
    for (int k = 0; k < count; k++)
        if (is_one(f, order / primes[k], h))
            return false;
    return true;
}

void polynomial_first_primitive(const field *f, polynomial *h)
{
    memset(h->c, 0, h->degree);
    h->c[h->degree] = 1;
    do {
        unsigned k = 0; /* the next number whose base-q digits are the coefficients */
        while (++h->c[k] == (uint8_t)f->q)
            h->c[k++] = 0;
    } while (!polynomial_is_primitive(f, h));
}
