/* A decoder of pseudorandom arrays that speaks the conformance protocol: JSON lines on standard
 * input and output, or one request with --one-shot. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "limits.h"
#include "operations.h"
#include "output.h"
#include "profile.h"

static array in_force;
static bool has_profile;

static const char *const reasons[] = {
    [INVALID] = "invalid",
    [OUT_OF_RANGE] = "out-of-range",
    [DIVISION_BY_ZERO] = "division-by-zero",
    [IMPOSSIBLE] = "impossible-profile",
    [TOO_FEW_CELLS] = "too-few-cells",
    [NO_COMPLETE_WINDOW] = "no-complete-window",
    [ZERO_WINDOW] = "zero-window",
    [NOT_IN_ARRAY] = "not-in-array",
    [OFF_SHEET] = "off-sheet",
    [CONTRADICTION] = "contradiction",
    [BEYOND_RADIUS] = "beyond-radius",
};

static void reply(const char *kind, const char *message)
{
    reply_with(kind);
    put("\"");
    put(message);
    put("\"}\n");
}

/* The rest of the reply after an operation. */
static void conclude(outcome came)
{
    switch (came) {
    case ANSWERED:
        put("}\n");
        break;
    case TOO_LARGE:
        reply_with("skipped");
        put("\"beyond the fixed buffers of this program\",\"link\":\"examples/c/limits.h\"}\n");
        break;
    case UNKNOWN:
        reply_with("skipped");
        put("\"no such operation\",\"link\":\"docs/reference/protocol.md\"}\n");
        break;
    default:
        reply("refused", reasons[came]);
    }
}

static void answer_true(void)
{
    reply_with("result");
    put("true");
}

static void answer_start(void)
{
    put("{\"protocol\":1,\"name\":\"c-example\",\"operations\":");
    operations_put();
    put(",\"in_flight\":256}\n");
}

static void take_profile(json request)
{
    outcome came = profile_read(&in_force, json_member(request, "profile"));
    has_profile = came == ANSWERED;
    if (has_profile)
        answer_true();
    conclude(came);
}

static void run(json request)
{
    reply_to(json_member(request, "sequence"));
    if (has_profile)
        conclude(operations_run(&in_force, json_member(request, "operation"),
                                json_member(request, "input")));
    else
        reply("errored", "no profile is in force");
    reply_to(NULL);
}

/* Answer a line; false if it is the request to stop. */
static bool answer(const char *line)
{
    json request = json_start(line);
    if (!json_valid(line) || *request != '{') {
        reply("errored", "the line is no request");
        return true;
    }
    json command = json_member(request, "command");
    if (json_equals(command, "start"))
        answer_start();
    else if (json_equals(command, "profile"))
        take_profile(request);
    else if (json_equals(command, "run"))
        run(request);
    else if (json_equals(command, "stop"))
        return false;
    else
        reply("errored", "no such command");
    return true;
}

/* A request that brings its profile along; without an operation it asks if that is possible. */
static void answer_one(const char *line)
{
    json request = json_start(line);
    if (!json_valid(line) || *request != '{') {
        reply("errored", "the line is no request");
        return;
    }
    reply_to(json_member(request, "sequence"));
    outcome came = profile_read(&in_force, json_member(request, "profile"));
    has_profile = came == ANSWERED;
    if (!has_profile)
        conclude(came);
    else if (json_member(request, "operation") != NULL)
        run(request);
    else {
        answer_true();
        conclude(ANSWERED);
    }
}

static char buffer[2 * MAX_LINE + 1];
static size_t held;

/* Answer the complete lines that are held; false if one of them says stop. */
static bool answer_lines(void)
{
    char *line = buffer, *end;
    while ((end = memchr(line, '\n', held - (size_t)(line - buffer))) != NULL) {
        *end = '\0';
        if (strlen(line) != (size_t)(end - line))
            reply("errored", "the line has a character that is none");
        else if (!answer(line))
            return false;
        line = end + 1;
    }
    held -= (size_t)(line - buffer);
    memmove(buffer, line, held);
    return true;
}

/* All requests that have come are answered before the replies are written. */
static void converse(void)
{
    for (;;) {
        ssize_t came = read(STDIN_FILENO, buffer + held, sizeof buffer - 1 - held);
        if (came <= 0)
            return;
        held += (size_t)came;
        bool more = answer_lines();
        if (held > MAX_LINE) {
            reply("errored", "the line is too long");
            more = false;
        }
        put_flush();
        if (!more)
            return;
    }
}

/* One line, or all there is. */
static bool read_line(void)
{
    while (held < MAX_LINE && memchr(buffer, '\n', held) == NULL) {
        ssize_t came = read(STDIN_FILENO, buffer + held, MAX_LINE - held);
        if (came < 0)
            return false;
        if (came == 0)
            break;
        held += (size_t)came;
    }
    buffer[held] = '\0';
    return true;
}

int main(int count, char **arguments)
{
    if (count == 1) {
        converse();
        return 0;
    }
    if (count != 2 || strcmp(arguments[1], "--one-shot") != 0) {
        fputs("usage: decoder [--one-shot]\n", stderr);
        return 2;
    }
    if (!read_line())
        return 1;
    answer_one(buffer);
    put_flush();
    return 0;
}
