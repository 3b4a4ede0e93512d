#include "factors.h"

#include <stdbool.h>

/* a b modulo n < 2^63, bit by bit: C99 has no number of 128 bits. */
static uint64_t times(uint64_t a, uint64_t b, uint64_t n)
{
    if (n <= UINT32_MAX)
        return a * b % n;
    uint64_t sum = 0;
    for (; b != 0; b >>= 1) {
        if (b & 1) {
            sum += a;
            if (sum >= n)
                sum -= n;
        }
        a += a;
        if (a >= n)
            a -= n;
    }
    return sum;
}

static uint64_t power(uint64_t a, uint64_t exponent, uint64_t n)
{
    uint64_t result = 1;
    for (; exponent != 0; exponent >>= 1, a = times(a, a, n))
        if (exponent & 1)
            result = times(result, a, n);
    return result;
}

/* Miller and Rabin's test of an odd number above 37; with these bases no composite number below
 * 2^64 passes. */
static bool is_prime(uint64_t n)
{
    static const unsigned bases[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    uint64_t odd = n - 1;
    int twos = 0;
    for (; odd % 2 == 0; odd /= 2)
        twos++;
    for (int k = 0; k < 12; k++) {
        uint64_t x = power(bases[k], odd, n);
        bool passes = x == 1;
        for (int s = 0; s < twos && !passes; s++, x = times(x, x, n))
            passes = x == n - 1;
        if (!passes)
            return false;
    }
    return true;
}

static uint64_t greatest_common_divisor(uint64_t a, uint64_t b)
{
    while (b != 0) {
        uint64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* A proper divisor of an odd composite number: where x -> x^2 + c runs into a cycle (Pollard). */
static uint64_t divisor(uint64_t n)
{
    for (uint64_t c = 1;; c++) {
        uint64_t slow = 2, fast = 2, d = 1;
        while (d == 1) {
            slow = (times(slow, slow, n) + c) % n;
            fast = (times(fast, fast, n) + c) % n;
            fast = (times(fast, fast, n) + c) % n;
            d = greatest_common_divisor(slow > fast ? slow - fast : fast - slow, n);
        }
        if (d != n)
            return d;
    }
}

static uint64_t without(uint64_t n, uint64_t prime)
{
    while (n % prime == 0)
        n /= prime;
    return n;
}

int prime_factors(uint64_t n, uint64_t primes[MAX_FACTORS])
{
    int count = 0;
    for (uint64_t d = 2; d < 1000 && d * d <= n; d++)
        if (n % d == 0) {
            primes[count++] = d;
            n = without(n, d);
        }
    while (n > 1) {
        uint64_t prime = n;
        while (prime > 1000000 && !is_prime(prime))
            prime = divisor(prime); /* what is below 1000^2 is prime by now */
        primes[count++] = prime;
        n = without(n, prime);
    }
    return count;
}
