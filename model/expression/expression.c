/* expression.c - recursive-descent parser with dimension checks; the result is a list
 * of operations in postfix order. */
#include "model/expression/expression.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "model/expression/expression_value.h"
#include "model/geometry/vec.h"

static const char *const functions[] = {"sqrt", "exp", "ln",   "log10", "abs",  "sin",
                                        "cos",  "tan", "asin", "acos",  "atan", "floor",
                                        "mod",  "min", "max",  "sum",   NULL};

const char *const *pp_expression_functions(void)
{
    return functions;
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

int pp_expression_name_length(const char *text)
{
    int length = 0;
    if (is_letter(text[0]))
        while (is_letter(text[length]) || is_digit(text[length]) || text[length] == '_'
               || text[length] == '\'')
            length++;
    return length;
}

/* ---- the parser ---- */

static const struct pp_dimension plain = {.number = true};

struct parser {
    const char *text, *at;
    int shift, nested;
    const struct pp_expression_name *names;
    int name_count;
    struct pp_expression *made;
    struct pp_expression_mistake *mistake;
    bool failed;
};

/* Result of parsing a part of the text. */
struct term {
    struct pp_dimension dimension;
    const char *start;
    bool constant; /* contains no quantity, so that value is known */
    double value;
};

static struct term sum(struct parser *parser);

static struct term fail(struct parser *parser, const char *at, const char *what)
{
    if (!parser->failed) {
        parser->mistake->column = (int)(at - parser->text) + parser->shift;
        snprintf(parser->mistake->what, sizeof parser->mistake->what, "%s", what);
    }
    parser->failed = true;
    return (struct term){.start = at};
}

static char peek(struct parser *parser)
{
    while (*parser->at == ' ')
        parser->at++;
    return *parser->at;
}

static bool accept_character(struct parser *parser, char c)
{
    if (peek(parser) != c)
        return false;
    parser->at++;
    return true;
}

static struct pp_operation *emit(struct parser *parser, enum pp_operation_kind kind,
                                 const char *at)
{
    struct pp_expression *made = parser->made;
    assert(made->count < PP_EXPRESSION_OPERATIONS_MOST);
    struct pp_operation *operation = &made->list[made->count++];
    *operation = (struct pp_operation){
        .kind = (unsigned char)kind,
        .column = (short)((int)(at - parser->text) + parser->shift)};
    return operation;
}

static struct term number_term(struct parser *parser, const char *at, double value)
{
    emit(parser, PP_DO_NUMBER, at)->number = value;
    return (struct term){plain, at, true, value};
}

static struct term number(struct parser *parser)
{
    const char *start = parser->at;
    char digits[PP_EXPRESSION_MOST + 1];
    int length = (int)strspn(start, "0123456789.");
    memcpy(digits, start, (size_t)length);
    digits[length] = '\0';
    double value;
    if (!pp_text_parse_number(digits, &value))
        return fail(parser, start,
                    "this is not a number; expected a number such as 0.85");
    parser->at += length;
    return number_term(parser, start, value);
}

static struct term unknown_name(struct parser *parser, const char *start, int length)
{
    const char *symbols[PP_EXPRESSION_MOST + 1];
    char typed[64], what[sizeof parser->mistake->what];
    int count = 0;
    for (int i = 0; i < parser->name_count && count < PP_EXPRESSION_MOST; i++)
        symbols[count++] = parser->names[i].symbol;
    snprintf(typed, sizeof typed, "%.*s", length, start);
    snprintf(what, sizeof what, "there is no quantity \"%s\"; expected ", typed);
    if (start[length] == '(')
        pp_text_append(what, sizeof what, "one of the functions, ");
    pp_text_append_list(what, sizeof what, symbols, count, " or ");
    return fail(parser, start, what);
}

static struct term name(struct parser *parser, const char *start, int length)
{
    struct pp_expression *made = parser->made;
    for (int i = 0; i < parser->name_count; i++) {
        if (!pp_text_is_word(parser->names[i].symbol, start, (size_t)length))
            continue;
        int known = 0;
        while (known < made->name_count && made->names[known] != i)
            known++;
        if (known == PP_EXPRESSION_NAMES_MOST)
            return fail(parser, start,
                        "the formula has too many different quantities; "
                        "expected fewer");
        made->names[known] = i;
        if (known == made->name_count)
            made->name_count++;
        emit(parser, PP_DO_NAME, start)->name = i;
        return (struct term){parser->names[i].dimension, start, false, NAN};
    }
    if (pp_text_is_word("pi", start, (size_t)length))
        return number_term(parser, start, PP_PI);
    return unknown_name(parser, start, length);
}

/* Fails because of a wrong dimension, which the message describes. */
static struct term wrong_dimension(struct parser *parser, const char *at,
                                   struct pp_dimension d, const char *expected)
{
    char is[96], what[sizeof parser->mistake->what];
    pp_dimension_describe(is, d);
    snprintf(what, sizeof what, "this is %s; expected %s", is, expected);
    return fail(parser, at, what);
}

/* Checks that a and b, which are to be added or compared, have the same dimension;
 * reports a mistake if not. */
static bool check_alike(struct parser *parser, const struct term *a,
                        const struct term *b)
{
    if (parser->failed || pp_dimension_alike(a->dimension, b->dimension))
        return !parser->failed;
    char first[96], expected[140];
    pp_dimension_describe(first, a->dimension);
    snprintf(expected, sizeof expected, "%s, to match the other term", first);
    wrong_dimension(parser, b->start, b->dimension, expected);
    return false;
}

static struct pp_dimension dimension_of_sum(struct pp_dimension a,
                                            struct pp_dimension b)
{
    return a.number ? b : a;
}

static struct pp_dimension dimension_of_call(struct parser *parser,
                                             enum pp_operation_kind kind,
                                             const struct term *argument)
{
    struct pp_dimension d = argument->dimension;
    const struct pp_dimension ratio = {0}, angle = {.degrees = 1.0};
    bool good = true;
    const char *expected = "a ratio";
    switch (kind) {
    case PP_DO_SQRT:
        return pp_dimension_raised(d, 0.5);
    case PP_DO_EXP:
    case PP_DO_LN:
    case PP_DO_LOG10:
        if (pp_dimension_is_ratio(d))
            return d;
        good = false;
        break;
    case PP_DO_SIN:
    case PP_DO_COS:
    case PP_DO_TAN:
        expected = "an angle, in degrees";
        good = pp_dimension_is_angle(d);
        d = ratio;
        break;
    case PP_DO_ASIN:
    case PP_DO_ACOS:
    case PP_DO_ATAN:
        good = pp_dimension_is_ratio(d);
        d = angle;
        break;
    default:
        return d;
    }
    if (!good && !parser->failed)
        wrong_dimension(parser, argument->start, argument->dimension, expected);
    return d;
}

static struct term call(struct parser *parser, enum pp_operation_kind kind,
                        const char *start)
{
    double values[PP_EXPRESSION_MOST];
    struct term all = {.start = start, .constant = true};
    int count = 0;
    if (!accept_character(parser, '('))
        return fail(parser, parser->at, "expected \"(\" after the function");
    const char *opened = parser->at - 1;
    do {
        struct term argument = sum(parser);
        if (parser->failed)
            return argument;
        if (count > 0 && kind < PP_DO_MOD)
            return fail(parser, argument.start,
                        "this function has one argument; expected \")\" after it");
        if (count > 1 && kind == PP_DO_MOD)
            return fail(parser, argument.start,
                        "mod has two arguments; expected \")\" after them");
        argument.dimension = dimension_of_call(parser, kind, &argument);
        if (count > 0 && !check_alike(parser, &all, &argument))
            return argument;
        all.dimension = count > 0 ? dimension_of_sum(all.dimension, argument.dimension)
                                  : argument.dimension;
        all.constant &= argument.constant;
        values[count++] = argument.value;
    } while (accept_character(parser, ','));
    if (!parser->failed && !accept_character(parser, ')')) {
        char what[96];
        snprintf(what, sizeof what, "expected \")\" for the \"(\" in column %d",
                 (int)(opened - parser->text) + parser->shift + 1);
        return fail(parser, parser->at, what);
    }
    if (!parser->failed && kind == PP_DO_MOD && count < 2)
        return fail(parser, parser->at - 1, "mod has two arguments; expected \",\"");
    emit(parser, kind, start)->count = (unsigned char)count;
    all.value = all.constant ? pp_expression_value_call(kind, values, count) : NAN;
    return all;
}

static struct term primary(struct parser *parser)
{
    char c = peek(parser);
    const char *start = parser->at;
    if (is_digit(c) || c == '.')
        return number(parser);
    int length = pp_expression_name_length(start);
    if (length > 0) {
        parser->at += length;
        for (int i = 0; functions[i]; i++)
            if (pp_text_is_word(functions[i], start, (size_t)length))
                return call(parser, (enum pp_operation_kind)(PP_DO_SQRT + i), start);
        return name(parser, start, length);
    }
    if (!accept_character(parser, '('))
        return fail(parser, start, "expected a number, a quantity or \"(\"");
    struct term inside = sum(parser);
    inside.start = start;
    if (!parser->failed && !accept_character(parser, ')')) {
        char what[96];
        snprintf(what, sizeof what, "expected \")\" for the \"(\" in column %d",
                 (int)(start - parser->text) + parser->shift + 1);
        return fail(parser, parser->at, what);
    }
    return inside;
}

static struct term power_parts(struct parser *parser);

static struct term power(struct parser *parser)
{
    if (parser->nested == PP_EXPRESSION_NESTED_MOST)
        return fail(parser, parser->at,
                    "parentheses and powers are nested too deeply; expected fewer "
                    "levels");
    parser->nested++;
    struct term term = power_parts(parser);
    parser->nested--;
    return term;
}

static struct term power_parts(struct parser *parser)
{
    peek(parser);
    const char *start = parser->at;
    if (accept_character(parser, '-')) {
        struct term term = power(parser);
        emit(parser, PP_DO_NEGATIVE, start);
        term.start = start;
        term.value = -term.value;
        return term;
    }
    struct term base = primary(parser);
    if (parser->failed || !accept_character(parser, '^'))
        return base;
    const char *sign = parser->at - 1;
    struct term exponent = power(parser);
    if (parser->failed)
        return exponent;
    if (!pp_dimension_is_ratio(exponent.dimension))
        return wrong_dimension(parser, exponent.start, exponent.dimension,
                               "a number as the exponent");
    if (!pp_dimension_is_ratio(base.dimension) && !exponent.constant)
        return wrong_dimension(parser, base.start, base.dimension,
                               "a ratio, because its exponent is not a plain number");
    emit(parser, PP_DO_POWER, sign);
    if (exponent.constant)
        base.dimension = pp_dimension_raised(base.dimension, exponent.value);
    else
        base.dimension.number |= exponent.dimension.number;
    base.constant &= exponent.constant;
    base.value = base.constant ? pow(base.value, exponent.value) : NAN;
    return base;
}

static bool begins_factor(char c)
{
    return is_letter(c) || is_digit(c) || c == '(' || c == '.';
}

static struct term product(struct parser *parser)
{
    struct term term = power(parser);
    while (!parser->failed) {
        char c = peek(parser);
        const char *sign = parser->at;
        bool over = accept_character(parser, '/');
        if (!over && !accept_character(parser, '*') && !begins_factor(c))
            break;
        struct term factor = power(parser);
        if (parser->failed)
            return factor;
        if (over && factor.constant && factor.value == 0.0)
            return fail(parser, factor.start,
                        "this divisor is 0; expected another number");
        emit(parser, over ? PP_DO_OVER : PP_DO_TIMES, sign);
        term.dimension =
            pp_dimension_times(term.dimension, factor.dimension, over ? -1.0 : 1.0);
        term.constant &= factor.constant;
        term.value = over ? term.value / factor.value : term.value * factor.value;
    }
    return term;
}

static struct term sum(struct parser *parser)
{
    struct term term = product(parser);
    while (!parser->failed) {
        peek(parser);
        const char *sign = parser->at;
        bool plus = accept_character(parser, '+');
        if (!plus && !accept_character(parser, '-'))
            break;
        struct term next = product(parser);
        if (!check_alike(parser, &term, &next))
            return next;
        emit(parser, plus ? PP_DO_PLUS : PP_DO_MINUS, sign);
        term.dimension = dimension_of_sum(term.dimension, next.dimension);
        term.constant &= next.constant;
        term.value = plus ? term.value + next.value : term.value - next.value;
    }
    return term;
}

bool pp_expression_parse(struct pp_expression *expression, const char *text, int shift,
                         const struct pp_expression_name *names, int count,
                         struct pp_expression_mistake *mistake)
{
    struct parser parser = {.text = text,
                            .at = text,
                            .shift = shift,
                            .names = names,
                            .name_count = count,
                            .made = expression,
                            .mistake = mistake};
    expression->count = expression->name_count = 0;
    if (strlen(text) > PP_EXPRESSION_MOST) {
        char what[64];
        snprintf(what, sizeof what,
                 "the formula is too long; expected at most %d characters",
                 PP_EXPRESSION_MOST);
        fail(&parser, text + PP_EXPRESSION_MOST, what);
        return false;
    }
    expression->dimension = sum(&parser).dimension;
    if (!parser.failed && peek(&parser))
        fail(&parser, parser.at,
             *parser.at == ')' ? "this \")\" has no \"(\"; expected the end of the "
                                 "formula"
                               : "expected +, -, *, /, ^ or the end of the formula");
    return !parser.failed;
}
