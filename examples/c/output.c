#include "output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char buffer[1 << 16];
static size_t used;

void put_flush(void)
{
    for (size_t done = 0; done < used;) {
        ssize_t written = write(STDOUT_FILENO, buffer + done, used - done);
        if (written <= 0)
            exit(1); /* nobody listens any more */
        done += (size_t)written;
    }
    used = 0;
}

void put_bytes(const char *bytes, size_t length)
{
    while (length > 0) {
        size_t room = sizeof buffer - used, part = length < room ? length : room;
        memcpy(buffer + used, bytes, part);
        used += part;
        bytes += part;
        length -= part;
        if (used == sizeof buffer)
            put_flush();
    }
}

void put(const char *text)
{
    put_bytes(text, strlen(text));
}

void put_number(uint64_t number)
{
    char digits[24], *at = digits + sizeof digits;
    const char *quote = number >> 53 ? "\"" : "";
    *--at = '\0';
    do
        *--at = (char)('0' + number % 10);
    while (number /= 10);
    put(quote);
    put(at);
    put(quote);
}

void put_real(double number)
{
    char text[40];
    snprintf(text, sizeof text, "%.17g", number);
    put(text);
}

static json sequence;

void reply_to(json given)
{
    sequence = given;
}

void reply_with(const char *kind)
{
    put("{");
    if (sequence != NULL) {
        put("\"sequence\":");
        put_bytes(sequence, (size_t)(json_end(sequence) - sequence));
        put(",");
    }
    put("\"");
    put(kind);
    put("\":");
}
