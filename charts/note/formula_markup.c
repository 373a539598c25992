/* formula_markup.c - see formula_markup.h. A name begins with a Latin or Greek letter,
 * continues with letters and digits, and may have subscripts. */
#include "charts/note/formula_markup.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "model/base/text.h"
#include "model/expression/expression.h"

void pp_formula_markup_words(char *markup, size_t room, const char *words)
{
    for (; *words; words++)
        if (*words == '<' || *words == '>' || *words == '&')
            pp_text_append(markup, room, "%s",
                           *words == '<'   ? "&lt;"
                           : *words == '>' ? "&gt;"
                                           : "&amp;");
        else
            pp_text_append(markup, room, "%c", *words);
}

/* Number of bytes of the Latin or Greek letter at text; 0: there is none. */
static int letter_length(const char *text)
{
    unsigned char first = (unsigned char)text[0];
    if (isalpha(first))
        return 1;
    return (first == 0xce || first == 0xcf) && text[1] ? 2 : 0;
}

static bool is_function(const char *name, int length)
{
    const char *const *functions = pp_expression_functions();
    for (; *functions; functions++)
        if ((int)strlen(*functions) == length
            && strncmp(*functions, name, (size_t)length) == 0)
            return true;
    return false;
}

/* Begins small type, raised by rise_mm (negative: lowered) before the layout is scaled
 * (lettering.c). Pango expects the rise in 1/1024 of a unit of the layout. */
static void begin_small(char *markup, size_t room, double rise_mm)
{
    pp_text_append(markup, room, "<span size=\"x-small\" rise=\"%d\">",
                   (int)lrint(1024.0 * rise_mm));
}

/* Appends the subscripts after a name, separated by commas. Returns the length of the
 * subscripts in text (bytes); 0: there are none. */
static int add_subscripts(char *markup, size_t room, const char *text, double size_mm)
{
    int at = 1;
    if (text[0] != '_')
        return 0;
    begin_small(markup, room, -0.22 * size_mm);
    for (; text[at] == '_' || isalnum((unsigned char)text[at]); at++)
        pp_text_append(markup, room, "%c", text[at] == '_' ? ',' : text[at]);
    pp_text_append(markup, room, "</span>");
    return at;
}

/* Appends an exponent such as "^2" as a superscript. Returns the length of the exponent
 * in text (bytes); 0: there is none. */
static int add_power(char *markup, size_t room, const char *text, double size_mm)
{
    int digits = text[0] == '^' ? (int)strspn(text + 1, "0123456789.") : 0;
    if (digits == 0)
        return 0;
    begin_small(markup, room, 0.35 * size_mm);
    pp_text_append(markup, room, "%.*s</span>", digits, text + 1);
    return 1 + digits;
}

/* Appends a character that is not part of a name or exponent; "*" becomes a
 * multiplication sign. */
static void add_sign(char *markup, size_t room, char sign)
{
    char words[2] = {sign, '\0'};
    pp_formula_markup_words(markup, room, sign == '*' ? "\u00d7" : words);
}

void pp_formula_markup(char *markup, size_t room, const char *formula, double size_mm)
{
    while (*formula) {
        int length = 0, letter;
        while ((letter = letter_length(formula + length)) > 0
               || (length && isdigit((unsigned char)formula[length])))
            length += letter > 0 ? letter : 1;
        int power = length ? 0 : add_power(markup, room, formula, size_mm);
        if (length == 0 && power == 0)
            add_sign(markup, room, *formula++);
        formula += power;
        if (length == 0)
            continue;
        bool upright = is_function(formula, length);
        pp_text_append(markup, room, upright ? "%.*s" : "<i>%.*s</i>", length, formula);
        formula += length;
        formula += add_subscripts(markup, room, formula, size_mm);
    }
}
