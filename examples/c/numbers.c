#include "numbers.h"

#include <stdio.h>
#include <string.h>

#include "output.h"

static char digits[JSON_DIGITS + 1];

static int natural_digits(json value)
{
    bool negative;
    int count = json_integer(value, digits, &negative);
    /* -0 is a number, too, if it is written as one. */
    bool nought = !json_is_string(value) && strspn(digits, "0") == (size_t)count;
    return count > 0 && negative && !nought ? 0 : count;
}

bool read_natural(json value, uint64_t *number)
{
    int count = natural_digits(value);
    *number = 0;
    for (int k = 0; k < count; k++) {
        unsigned digit = (unsigned)(digits[k] - '0');
        if (*number > (UINT64_MAX - digit) / 10)
            *number = UINT64_MAX;
        else
            *number = *number * 10 + digit;
    }
    return count > 0;
}

static uint32_t rest_of(int count, uint32_t modulus)
{
    uint64_t rest = 0;
    for (int k = 0; k < count; k++)
        rest = (rest * 10 + (unsigned)(digits[k] - '0')) % modulus;
    return (uint32_t)rest;
}

bool read_modulo(json value, uint32_t modulus, uint32_t *rest)
{
    int count = natural_digits(value);
    *rest = rest_of(count, modulus);
    return count > 0;
}

bool read_integer(json value, uint32_t modulus, uint32_t *rest, bool *zero, bool *negative)
{
    int count = json_integer(value, digits, negative);
    *rest = rest_of(count, modulus);
    if (*negative)
        *rest = (modulus - *rest) % modulus;
    *zero = strspn(digits, "0") == (size_t)count;
    return count > 0;
}

bool read_large(json value, large *number)
{
    int count = natural_digits(value);
    number->used = 0;
    for (int k = 0; k < count; k++)
        large_multiply_add(number, 10, (uint32_t)(digits[k] - '0'));
    return count > 0;
}

enum { BASE = 1000000000 };

void large_multiply_add(large *number, uint32_t factor, uint32_t summand)
{
    uint64_t carry = summand;
    for (int k = 0; k < number->used; k++) {
        carry += (uint64_t)number->limb[k] * factor;
        number->limb[k] = (uint32_t)(carry % BASE);
        carry /= BASE;
    }
    if (carry > 0)
        number->limb[number->used++] = (uint32_t)carry;
}

uint32_t large_divide(large *number, uint32_t divisor)
{
    uint64_t rest = 0;
    for (int k = number->used; k-- > 0;) {
        rest = rest * BASE + number->limb[k];
        number->limb[k] = (uint32_t)(rest / divisor);
        rest %= divisor;
    }
    while (number->used > 0 && number->limb[number->used - 1] == 0)
        number->used--;
    return (uint32_t)rest;
}

void large_put(const large *number)
{
    if (number->used <= 2) { /* below 10^18 */
        uint64_t small = 0;
        for (int k = number->used; k-- > 0;)
            small = small * BASE + number->limb[k];
        put_number(small);
        return;
    }
    char text[12];
    put("\"");
    for (int k = number->used; k-- > 0;) {
        snprintf(text, sizeof text, k == number->used - 1 ? "%lu" : "%09lu",
                 (unsigned long)number->limb[k]);
        put(text);
    }
    put("\"");
}
