#include "json.h"

#include <string.h>

json json_start(const char *text)
{
    while (*text == ' ' || *text == '\t' || *text == '\r' || *text == '\n')
        text++;
    return text;
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Each of these returns what is behind a value, or NULL if there is none. */
static const char *past_digits(const char *at)
{
    if (!is_digit(*at))
        return NULL;
    while (is_digit(*at))
        at++;
    return at;
}

static const char *past_number(const char *at)
{
    at += *at == '-';
    if (*at == '0')
        at++;
    else if ((at = past_digits(at)) == NULL)
        return NULL;
    if (*at == '.' && (at = past_digits(at + 1)) == NULL)
        return NULL;
    if (*at == 'e' || *at == 'E') {
        at++;
        at += *at == '+' || *at == '-';
        return past_digits(at);
    }
    return at;
}

static int hexadecimal(char c)
{
    if (is_digit(c))
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

static const char *past_string(const char *at)
{
    for (at++; *at != '"'; at++) {
        if ((unsigned char)*at < ' ')
            return NULL;
        if (*at != '\\')
            continue;
        at++;
        if (*at == 'u') {
            for (int k = 1; k <= 4; k++)
                if (hexadecimal(at[k]) < 0)
                    return NULL;
            at += 4;
        } else if (*at == '\0' || strchr("\"\\/bfnrt", *at) == NULL) {
            return NULL;
        }
    }
    return at + 1;
}

static const char *past_word(const char *at)
{
    static const char *const words[] = {"true", "false", "null"};
    for (int k = 0; k < 3; k++)
        if (strncmp(at, words[k], strlen(words[k])) == 0)
            return at + strlen(words[k]);
    return NULL;
}

static const char *past_value(const char *at, int depth);

/* The inside of a list or an object. */
static const char *past_items(const char *at, char closing, int depth)
{
    if (depth > JSON_DEPTH)
        return NULL;
    at = json_start(at + 1);
    if (*at == closing)
        return at + 1;
    for (;;) {
        if (closing == '}') {
            if (*at != '"' || (at = past_string(at)) == NULL)
                return NULL;
            at = json_start(at);
            if (*at != ':')
                return NULL;
            at = json_start(at + 1);
        }
        if ((at = past_value(at, depth)) == NULL)
            return NULL;
        at = json_start(at);
        if (*at == closing)
            return at + 1;
        if (*at != ',')
            return NULL;
        at = json_start(at + 1);
    }
}

static const char *past_value(const char *at, int depth)
{
    switch (*at) {
    case '{':
        return past_items(at, '}', depth + 1);
    case '[':
        return past_items(at, ']', depth + 1);
    case '"':
        return past_string(at);
    default:
        return is_digit(*at) || *at == '-' ? past_number(at) : past_word(at);
    }
}

bool json_valid(const char *text)
{
    const char *end = past_value(json_start(text), 0);
    return end != NULL && *json_start(end) == '\0';
}

json json_end(json value)
{
    return past_value(value, 0);
}

json json_member(json object, const char *key)
{
    json found = NULL;
    if (object == NULL || *object != '{')
        return NULL;
    json at = json_start(object + 1);
    while (*at == '"') {
        bool wanted = json_equals(at, key);
        json value = json_start(json_start(past_string(at)) + 1);
        if (wanted)
            found = value;
        at = json_start(json_end(value));
        if (*at == ',')
            at = json_start(at + 1);
    }
    return found;
}

json json_first(json list)
{
    json first = json_start(list + 1);
    return *first == ']' ? NULL : first;
}

json json_next(json item)
{
    json at = json_start(json_end(item));
    return *at == ',' ? json_start(at + 1) : NULL;
}

bool json_is_list(json value)
{
    return value != NULL && *value == '[';
}

bool json_is_null(json value)
{
    return value != NULL && *value == 'n';
}

bool json_is_number(json value)
{
    return value != NULL && (is_digit(*value) || *value == '-');
}

bool json_is_string(json value)
{
    return value != NULL && *value == '"';
}

int json_character(json *cursor)
{
    static const char escapes[] = "bfnrt", meant[] = "\b\f\n\r\t";
    json at = *cursor;
    int character = (unsigned char)*at++;
    if (character == '"')
        return -1;
    if (character == '\\') {
        character = (unsigned char)*at++;
        const char *escape = strchr(escapes, character);
        if (character == 'u') {
            character = 0;
            for (int k = 0; k < 4; k++)
                character = 16 * character + hexadecimal(*at++);
        } else if (escape != NULL) {
            character = meant[escape - escapes];
        }
    }
    *cursor = at;
    return character;
}

bool json_equals(json value, const char *text)
{
    if (!json_is_string(value))
        return false;
    json at = value + 1;
    for (;; text++) {
        int character = json_character(&at);
        if (character < 0)
            return *text == '\0';
        if (character != (unsigned char)*text)
            return false;
    }
}

int json_integer(json value, char digits[JSON_DIGITS + 1], bool *negative)
{
    bool string = json_is_string(value);
    *negative = false;
    if (!string && !json_is_number(value))
        return 0;
    json at = string ? value + 1 : value, end = string ? NULL : json_end(value);
    int count = 0;
    for (bool first = true;; first = false) {
        int character = string ? json_character(&at) : at == end ? -1 : *at++;
        if (character < 0)
            break;
        if (first && character == '-') {
            *negative = true;
            continue;
        }
        if (character < '0' || character > '9' || count == JSON_DIGITS)
            return 0;
        digits[count++] = (char)character;
    }
    digits[count] = '\0';
    return count;
}
