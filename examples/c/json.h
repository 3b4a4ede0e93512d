/* Reading JSON where it stands. A value is a pointer to its first character in a line that was
 * found valid; nothing is copied and nothing is allocated. */
#ifndef JSON_H
#define JSON_H

#include <stdbool.h>

enum { JSON_DEPTH = 64, JSON_DIGITS = 4096 };

typedef const char *json;

/* Whether the text is one value, nested at most JSON_DEPTH deep, and nothing else. */
bool json_valid(const char *text);

/* The first character of the text that is no white space. */
json json_start(const char *text);

/* Behind the value. */
json json_end(json value);

/* The value under a key, the last one if there are several; NULL if there is none, or no object. */
json json_member(json object, const char *key);

/* The items of a list, one after the other; NULL behind the last. */
json json_first(json list);
json json_next(json item);

bool json_is_list(json value);
bool json_is_null(json value);
bool json_is_number(json value);
bool json_is_string(json value);

/* Whether it is this text, which has no characters beyond ASCII. */
bool json_equals(json value, const char *text);

/* The next character of a string, its escapes undone: to begin with, the cursor points behind the
 * quotation mark. -1 at the end; characters beyond ASCII are some number above 127. */
int json_character(json *cursor);

/* The decimal digits of a whole number, written plainly or as a string. How many they are; 0 if it
 * is something else, such as 2.0, 2e0 or true, or has more than JSON_DIGITS. */
int json_integer(json value, char digits[JSON_DIGITS + 1], bool *negative);

#endif
