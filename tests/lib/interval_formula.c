/* interval_formula.c - evaluates a formula in interval arithmetic, by recursive
 * descent:
 *
 *     sum     = product { (+|-) product }
 *     product = power { [*|/] power }        from left to right; side by side: times
 *     power   = - power | primary [ ^ power ]
 *     primary = number | pi | symbol | function ( sum {, sum} ) | ( sum )
 *
 * A minus binds less tightly than ^ and more tightly than *.
 */
#include "tests/lib/interval_formula.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180.0;

void figures_add(struct figures *figures, const char *symbol, struct interval value)
{
    if (figures->count == sizeof figures->list / sizeof figures->list[0])
        abort();
    struct figure *figure = &figures->list[figures->count++];
    snprintf(figure->symbol, sizeof figure->symbol, "%s", symbol);
    figure->value = value;
}

struct interval figure_as_printed(const char *digits)
{
    const char *point = strchr(digits, '.');
    double value = strtod(digits, NULL);
    double half = 0.5 * pow(10.0, point ? -(double)strlen(point + 1) : 0.0);
    return (struct interval){value - half, value + half};
}

struct parser {
    const char *at;
    const struct figures *figures;
    char *message;
    bool failed;
};

static struct interval sum(struct parser *parser);

static struct interval fail(struct parser *parser, const char *what)
{
    if (!parser->failed)
        snprintf(parser->message, 128, "%.60s at \"%.40s\"", what, parser->at);
    parser->failed = true;
    return (struct interval){NAN, NAN};
}

static char peek(struct parser *parser)
{
    parser->at += strspn(parser->at, " ");
    return *parser->at;
}

static bool take(struct parser *parser, char c)
{
    if (peek(parser) != c)
        return false;
    parser->at++;
    return true;
}

/* ---- arithmetic ---- */

static struct interval hull(const double *values, int count)
{
    struct interval all = {INFINITY, -INFINITY};
    for (int i = 0; i < count; i++) {
        all.low = fmin(all.low, values[i]);
        all.high = fmax(all.high, values[i]);
    }
    return all;
}

static struct interval times(struct interval a, struct interval b)
{
    double corners[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return hull(corners, 4);
}

static struct interval over(struct parser *parser, struct interval a, struct interval b)
{
    if (b.low <= 0.0 && b.high >= 0.0)
        return fail(parser, "division by what may be 0");
    return times(a, (struct interval){1.0 / b.high, 1.0 / b.low});
}

/* a to the power b, for a >= 0 or integer b. */
static struct interval power_of(struct interval a, struct interval b)
{
    double corners[5] = {pow(a.low, b.low), pow(a.low, b.high), pow(a.high, b.low),
                         pow(a.high, b.high), 0.0};
    bool through_zero = a.low < 0.0 && a.high > 0.0;
    return hull(corners, through_zero ? 5 : 4);
}

/* True if a value offset + 360 k lies in the interval (degrees). */
static bool has_turn(struct interval a, double offset)
{
    return ceil((a.low - offset) / 360.0) <= floor((a.high - offset) / 360.0);
}

static struct interval sine(struct interval a)
{
    double ends[] = {sin(a.low * degree), sin(a.high * degree)};
    struct interval value = hull(ends, 2);
    if (has_turn(a, 90.0))
        value.high = 1.0;
    if (has_turn(a, -90.0))
        value.low = -1.0;
    return value;
}

static struct interval cosine(struct interval a)
{
    return sine((struct interval){a.low + 90.0, a.high + 90.0});
}

/* ---- the grammar ---- */

static struct interval call(struct parser *parser, const char *name)
{
    struct interval list[16];
    int count = 0;
    do {
        if (count == 16)
            return fail(parser, "too many arguments");
        list[count++] = sum(parser);
    } while (!parser->failed && take(parser, ','));
    if (!parser->failed && !take(parser, ')'))
        return fail(parser, "expected )");
    if (parser->failed)
        return list[0];

    struct interval value = list[0], a = list[0];
    for (int i = 1; i < count; i++) {
        struct interval b = list[i];
        if (strcmp(name, "min") == 0)
            value = (struct interval){fmin(value.low, b.low), fmin(value.high, b.high)};
        else if (strcmp(name, "max") == 0)
            value = (struct interval){fmax(value.low, b.low), fmax(value.high, b.high)};
        else if (strcmp(name, "sum") == 0)
            value = (struct interval){value.low + b.low, value.high + b.high};
        else
            return fail(parser, "a function of one argument has more");
    }
    if (strcmp(name, "sqrt") == 0)
        value = (struct interval){sqrt(fmax(a.low, 0.0)), sqrt(a.high)};
    else if (strcmp(name, "abs") == 0)
        value = (struct interval){fmax(fmax(a.low, -a.high), 0.0),
                                  fmax(fabs(a.low), fabs(a.high))};
    else if (strcmp(name, "exp") == 0)
        value = (struct interval){exp(a.low), exp(a.high)};
    else if (strcmp(name, "log") == 0)
        value = (struct interval){log(a.low), log(a.high)};
    else if (strcmp(name, "sin") == 0)
        value = sine(a);
    else if (strcmp(name, "cos") == 0)
        value = cosine(a);
    else if (strcmp(name, "tan") == 0)
        value = over(parser, sine(a), cosine(a));
    else if (strcmp(name, "atan") == 0)
        value = (struct interval){atan(a.low) / degree, atan(a.high) / degree};
    return value;
}

static bool is_function(const char *name)
{
    static const char *const names[] = {"sqrt", "abs",  "exp", "log", "sin", "cos",
                                        "tan",  "atan", "min", "max", "sum"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    return false;
}

static struct interval symbol(struct parser *parser)
{
    char name[32];
    int length = 0;
    while (isalnum((unsigned char)parser->at[length]) || parser->at[length] == '_'
           || parser->at[length] == '\'')
        length++;
    if (length >= (int)sizeof name)
        return fail(parser, "a long symbol");
    snprintf(name, sizeof name, "%.*s", length, parser->at);
    if (is_function(name)) {
        parser->at += length;
        return take(parser, '(') ? call(parser, name) : fail(parser, "expected (");
    }
    for (int i = parser->figures->count - 1; i >= 0; i--)
        if (strcmp(parser->figures->list[i].symbol, name) == 0) {
            parser->at += length;
            return parser->figures->list[i].value;
        }
    if (strcmp(name, "pi") == 0) {
        const double pi = 180.0 * degree;
        parser->at += length;
        return (struct interval){pi, pi};
    }
    return fail(parser, "a symbol that is not set down before");
}

static struct interval primary(struct parser *parser)
{
    char c = peek(parser);
    if (isdigit((unsigned char)c) || c == '.') {
        char *end;
        double value = strtod(parser->at, &end);
        parser->at = end;
        return (struct interval){value, value};
    }
    if (isalpha((unsigned char)c))
        return symbol(parser);
    if (!take(parser, '('))
        return fail(parser, "expected a figure");
    struct interval value = sum(parser);
    if (!parser->failed && !take(parser, ')'))
        return fail(parser, "expected )");
    return value;
}

static struct interval power(struct parser *parser)
{
    if (take(parser, '-')) {
        struct interval value = power(parser);
        return (struct interval){-value.high, -value.low};
    }
    struct interval base = primary(parser);
    if (parser->failed || !take(parser, '^'))
        return base;
    return power_of(base, power(parser));
}

static struct interval product(struct parser *parser)
{
    struct interval value = power(parser);
    while (!parser->failed) {
        char c = peek(parser);
        if (take(parser, '/'))
            value = over(parser, value, power(parser));
        else if (take(parser, '*') || isalnum((unsigned char)c) || c == '(' || c == '.')
            value = times(value, power(parser));
        else
            break;
    }
    return value;
}

static struct interval sum(struct parser *parser)
{
    struct interval value = product(parser);
    while (!parser->failed) {
        bool plus = take(parser, '+');
        if (!plus && !take(parser, '-'))
            break;
        struct interval next = product(parser);
        value = plus ? (struct interval){value.low + next.low, value.high + next.high}
                     : (struct interval){value.low - next.high, value.high - next.low};
    }
    return value;
}

bool formula_evaluate(struct interval *value, const char *formula,
                      const struct figures *figures, char message[128])
{
    struct parser parser = {formula, figures, message, false};
    *value = sum(&parser);
    if (!parser.failed && peek(&parser))
        *value = fail(&parser, "what is this");
    return !parser.failed;
}
