/* element_form.c - see element_form.h. */
#include "model/room/read/element_form.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/light/finishes.h"
#include "model/light/glazings.h"

enum { NAMES_MOST = 64, SENTENCE = 1024 };

bool pp_element_form_matches(const struct pp_xml_element *element,
                             const struct pp_element_rule *rule)
{
    return strcmp(element->name, rule->name) == 0;
}

/* A value that is being read, with its element and attribute for error messages. */
struct value_place {
    const char *element, *attribute;
    const struct pp_value_kind *kind;
    const char *text;
    int line;
    struct pp_mistakes *mistakes;
    double per_metre;
    const struct pp_rough_finishes *materials;
};

/* Expected values of the kind, for a message, in the units of the file. */
static const char *expected_of(const struct pp_value_kind *kind, double per_metre)
{
    return kind->expected_mm && per_metre > 1.0 ? kind->expected_mm : kind->expected;
}

static bool wrong(const struct value_place *at, const char *more)
{
    char shown[160];
    pp_mistakes_add(at->mistakes, at->line, "%s: %s is \"%s\"; expected %s%s",
                    at->element, at->attribute,
                    pp_text_excerpt(shown, sizeof shown, at->text),
                    expected_of(at->kind, at->per_metre), more);
    return false;
}

static bool in_range(const struct pp_value_kind *kind, double value)
{
    bool low = kind->above_least ? value > kind->least : value >= kind->least;
    bool high = kind->below_most ? value < kind->most : value <= kind->most;
    return low && high;
}

/* Converts lengths to metres by a division, which gives the double nearest to the
 * decimal fraction. */
static void to_metres(double *value, const struct value_place *at)
{
    if (at->kind->expected_mm)
        *value /= at->per_metre;
}

static bool read_form_number(double *value, const struct value_place *at)
{
    if (!pp_text_parse_number(at->text, value))
        return wrong(at, strchr(at->text, ',') ? " (with a decimal point, not a comma)"
                                               : "");
    to_metres(value, at);
    return in_range(at->kind, *value) || wrong(at, "");
}

/* Reports an unknown name, with the most similar name and all valid ones. */
static bool unknown(const struct value_place *at, const char *const *names, int count)
{
    char more[SENTENCE] = "", list[SENTENCE];
    pp_text_append_nearest(more, sizeof more, at->text, names, count);
    pp_text_append(more, sizeof more, " (%s)",
                   pp_text_list_names(list, sizeof list, names, count));
    return wrong(at, more);
}

/* True if the text is a number or looks like one. *good is true for a number in range;
 * any other is reported. */
static bool is_meant_for_number(double *value, bool *good, const struct value_place *at)
{
    if (pp_text_parse_number(at->text, value)) {
        *good = in_range(at->kind, *value) || wrong(at, "");
        return true;
    }
    *good = false;
    return strpbrk(at->text, "0123456789") && !wrong(at, "");
}

static bool read_factor(double *value, const struct value_place *at)
{
    const struct pp_named_factors *factors = at->kind->factors;
    const struct pp_named_factor *factor = pp_corrections_find(factors, at->text);
    bool good;
    if (factor) {
        *value = factor->factor;
        return true;
    }
    if (is_meant_for_number(value, &good, at))
        return good;
    const char *names[NAMES_MOST];
    int count = 0;
    while (count < factors->count && count < NAMES_MOST) {
        names[count] = factors->list[count].name;
        count++;
    }
    return unknown(at, names, count);
}

/* Reads the name of one of the file's own materials, after "#". */
static bool read_own_material(struct pp_finish_value *value,
                              const struct value_place *at)
{
    const struct pp_rough_finish *own =
        pp_rough_finishes_find(at->materials, at->text + 1);
    if (!own)
        return wrong(at, "");
    if (own->has_pattern && at->kind->without_pattern)
        return wrong(
            at, ", without a pattern or bumps, which only surfaces in a room can have");
    value->finish = &own->finish;
    value->reflectance = own->finish.reflectance;
    return true;
}

static bool read_reflectance(struct pp_finish_value *value,
                             const struct value_place *at)
{
    bool good;
    if (at->text[0] == '#')
        return read_own_material(value, at);
    value->finish = pp_finishes_find(at->text);
    if (value->finish) {
        value->reflectance = value->finish->reflectance;
        return true;
    }
    if (is_meant_for_number(&value->reflectance, &good, at))
        return good;
    const char *names[NAMES_MOST];
    int count = 0;
    while (count < pp_finishes_count() && count < NAMES_MOST) {
        names[count] = pp_finishes_at(count)->name;
        count++;
    }
    return unknown(at, names, count);
}

static bool read_glazing(const char **name, const struct value_place *at)
{
    *name = at->text;
    if (strcmp(at->text, "none") == 0 || pp_glazings_find(at->text))
        return true;
    const char *names[NAMES_MOST] = {"none"};
    int count = 1;
    while (count <= pp_glazings_count() && count < NAMES_MOST) {
        names[count] = pp_glazings_at(count - 1)->name;
        count++;
    }
    return unknown(at, names, count);
}

static bool read_choice(int *index, const struct value_place *at)
{
    const char *const *words = at->kind->words;
    for (*index = 0; words[*index]; ++*index)
        if (strcmp(words[*index], at->text) == 0)
            return true;
    char more[64] = "";
    if (words[1]) /* several words */
        pp_text_append_nearest(more, sizeof more, at->text, words, -1);
    return wrong(at, more);
}

static bool read_pair(double *pair, const struct value_place *at)
{
    static const char white[] = " \t\r\n";
    const char *first = at->text + strspn(at->text, white);
    size_t length = strcspn(first, white);
    char copy[64];
    if (length >= sizeof copy)
        return wrong(at, "");
    memcpy(copy, first, length);
    copy[length] = '\0';
    if (!pp_text_parse_number(copy, &pair[0])
        || !pp_text_parse_number(first + length, &pair[1]))
        return wrong(at, "");
    to_metres(&pair[0], at);
    to_metres(&pair[1], at);
    return (in_range(at->kind, pair[0]) && in_range(at->kind, pair[1]))
           || wrong(at, "");
}

/* Reads one number for all three channels, or three. */
static bool read_triple(double *triple, const struct value_place *at)
{
    static const char white[] = " \t\r\n";
    const char *next = at->text + strspn(at->text, white);
    int count = 0;
    for (; *next && count <= 3; next += strspn(next, white)) {
        size_t length = strcspn(next, white);
        char copy[64];
        if (count == 3 || length >= sizeof copy)
            return wrong(at, "");
        memcpy(copy, next, length);
        copy[length] = '\0';
        if (!pp_text_parse_number(copy, &triple[count])
            || !in_range(at->kind, triple[count]))
            return wrong(at, "");
        count++;
        next += length;
    }
    if (count == 1)
        triple[1] = triple[2] = triple[0];
    return count == 1 || count == 3 || wrong(at, "");
}

static bool read_count(int *count, const struct value_place *at)
{
    double value;
    if (at->text[strspn(at->text, "+0123456789 \t\r\n")] != '\0')
        return wrong(at, "");
    if (!read_form_number(&value, at))
        return false;
    *count = (int)value;
    return true;
}

static bool read_value(void *field, const struct value_place *at)
{
    double number = NAN, pair[2], triple[3];
    struct pp_finish_value finish = {.reflectance = NAN};
    int index = 0;
    const char *name = at->text;
    bool good = true;
    switch (at->kind->reading) {
    case PP_VALUE_NAME:
        good = name[0] != '\0' || wrong(at, "");
        good = good
               && (pp_text_is_plain(name) || wrong(at, " without control characters"));
        break;
    case PP_VALUE_TEXT:
        good = pp_text_is_plain(name) || wrong(at, "");
        break;
    case PP_VALUE_NUMBER:
        good = read_form_number(&number, at);
        number *= at->kind->unit;
        break;
    case PP_VALUE_REFLECTANCE:
        good = read_reflectance(&finish, at);
        memcpy(field, &finish, sizeof finish);
        return good;
    case PP_VALUE_AUTO:
        good = strcmp(name, "auto") == 0 || read_form_number(&number, at);
        break;
    case PP_VALUE_FACTOR:
        good = read_factor(&number, at);
        break;
    case PP_VALUE_GLAZING:
        good = read_glazing(&name, at);
        break;
    case PP_VALUE_PAIR:
        good = read_pair(pair, at);
        if (good)
            memcpy(field, pair, sizeof pair);
        return good;
    case PP_VALUE_TRIPLE:
        good = read_triple(triple, at);
        if (good)
            memcpy(field, triple, sizeof triple);
        return good;
    case PP_VALUE_CHOICE:
        good = read_choice(&index, at);
        memcpy(field, &index, sizeof index);
        return good;
    case PP_VALUE_COUNT:
        good = read_count(&index, at);
        memcpy(field, &index, sizeof index);
        return good;
    }
    enum pp_reading_of_value reading = at->kind->reading;
    if (reading == PP_VALUE_TEXT || reading == PP_VALUE_NAME
        || reading == PP_VALUE_GLAZING)
        memcpy(field, &name, sizeof name);
    else
        memcpy(field, &number, sizeof number);
    return good;
}

static void store_fallback(void *field, const struct pp_attribute_rule *row)
{
    const char *no_text = NULL;
    int index = isfinite(row->fallback) ? (int)row->fallback : -1;
    double three[3] = {row->fallback, row->fallback, row->fallback};
    struct pp_finish_value number = {.reflectance = row->fallback};
    switch (row->kind->reading) {
    case PP_VALUE_TEXT:
    case PP_VALUE_NAME:
    case PP_VALUE_GLAZING:
        memcpy(field, &no_text, sizeof no_text);
        break;
    case PP_VALUE_REFLECTANCE:
        memcpy(field, &number, sizeof number);
        break;
    case PP_VALUE_NUMBER:
    case PP_VALUE_AUTO:
    case PP_VALUE_FACTOR:
        memcpy(field, &row->fallback, sizeof row->fallback);
        break;
    case PP_VALUE_PAIR:
        memcpy(field, three, 2 * sizeof *three);
        break;
    case PP_VALUE_TRIPLE:
        memcpy(field, three, sizeof three);
        break;
    case PP_VALUE_COUNT:
    case PP_VALUE_CHOICE:
        memcpy(field, &index, sizeof index);
        break;
    }
}

static const struct pp_xml_attribute *find_attribute(
    const struct pp_xml_element *element, const char *name)
{
    for (int i = 0; i < element->attribute_count; i++)
        if (strcmp(element->attributes[i].name, name) == 0)
            return &element->attributes[i];
    return NULL;
}

/* Reports that `what` ("attribute", "element") `name` is unknown in `within`. */
static void note_unknown(struct pp_mistakes *mistakes, int line, const char *what,
                         const char *name, const char *within, const char *const *names,
                         int count)
{
    char shown[160], list[SENTENCE], question[160];
    const char *meant = pp_text_nearest(name, names, count);
    pp_text_did_you_mean(question, sizeof question, "\"", meant, "\"");
    pp_text_list_names(list, sizeof list, names, count);
    pp_mistakes_add(mistakes, line, "%s: %s \"%s\" is unknown; %s%s%s%s", within, what,
                    pp_text_excerpt(shown, sizeof shown, name), question,
                    meant ? " (" : "expected ", count > 0 ? list : "none",
                    meant ? ")" : "");
}

static int attribute_names(const char **names, const struct pp_element_rule *rule)
{
    for (int i = 0; i < rule->attribute_count; i++)
        names[i] = rule->attributes[i].name;
    return rule->attribute_count;
}

static int child_names(const char **names, const struct pp_element_rule *rule)
{
    for (int i = 0; i < rule->child_count; i++)
        names[i] = rule->children[i].rule->name;
    return rule->child_count;
}

static bool attributes_known(const struct pp_element_rule *rule,
                             const struct pp_xml_element *element,
                             struct pp_mistakes *mistakes)
{
    const char *names[NAMES_MOST];
    attribute_names(names, rule);
    bool good = true;
    for (int k = 0; k < element->attribute_count; k++) {
        const struct pp_xml_attribute *attribute = &element->attributes[k];
        bool known = false;
        for (int i = 0; i < rule->attribute_count && !known; i++)
            known = strcmp(names[i], attribute->name) == 0;
        if (!known)
            note_unknown(mistakes, attribute->line, "attribute", attribute->name,
                         rule->name, names, rule->attribute_count);
        good = good && known;
    }
    return good;
}

/* True if an unknown attribute of the element resembles this attribute most; the
 * attribute is then not reported as missing. */
static bool is_misspelt(const struct pp_element_rule *rule,
                        const struct pp_xml_element *element, const char *name)
{
    const char *names[NAMES_MOST];
    int count = attribute_names(names, rule);
    for (int k = 0; k < element->attribute_count; k++) {
        const char *meant = pp_text_nearest(element->attributes[k].name, names, count);
        if (meant && strcmp(meant, name) == 0)
            return true;
    }
    return false;
}

bool pp_element_form_fill(void *form, const struct pp_element_rule *rule,
                          const struct pp_xml_element *element, double per_metre,
                          const struct pp_rough_finishes *materials,
                          struct pp_mistakes *mistakes)
{
    bool good = attributes_known(rule, element, mistakes);
    for (int i = 0; i < rule->attribute_count; i++) {
        const struct pp_attribute_rule *row = &rule->attributes[i];
        void *field = (char *)form + row->offset;
        const struct pp_xml_attribute *attribute = find_attribute(element, row->name);
        store_fallback(field, row);
        if (attribute) {
            struct value_place at = {rule->name,       row->name,       row->kind,
                                     attribute->value, attribute->line, mistakes,
                                     per_metre,        materials};
            good = read_value(field, &at) && good;
        } else if (row->required) {
            good = false;
            /* A truncated tag may have lost this attribute. */
            if (!element->ended || is_misspelt(rule, element, row->name))
                continue;
            pp_mistakes_add(mistakes, element->line, "%s: %s is missing; expected %s",
                            rule->name, row->name, expected_of(row->kind, per_metre));
        }
    }
    return good;
}

static bool children_known(const struct pp_element_rule *rule,
                           const struct pp_xml_element *element,
                           struct pp_mistakes *mistakes)
{
    const char *names[NAMES_MOST];
    child_names(names, rule);
    int unknown_count = 0;
    for (const struct pp_xml_element *c = element->child;
         c && unknown_count < PP_MISTAKES_MOST; c = c->next) {
        bool known = false;
        for (int i = 0; i < rule->child_count && !known; i++)
            known = strcmp(names[i], c->name) == 0;
        if (!known)
            note_unknown(mistakes, c->line, "element", c->name, rule->name, names,
                         rule->child_count);
        unknown_count += !known;
    }
    return unknown_count == 0;
}

/* Reports too many or too few children of one kind, and returns false. */
static bool count_is_good(const struct pp_element_rule *rule,
                          const struct pp_child_rule *child,
                          const struct pp_xml_element *element, bool may_be_fewer,
                          struct pp_mistakes *mistakes)
{
    const char *name = child->rule->name;
    int count = 0, first = 0;
    for (const struct pp_xml_element *c = element->child; c; c = c->next) {
        if (!pp_element_form_matches(c, child->rule))
            continue;
        if (++count == 1)
            first = c->line;
        if (child->most == 1 && count == 2)
            pp_mistakes_add(mistakes, c->line,
                            "%s: there is a second <%s>, after the one on line %d; "
                            "expected only one",
                            rule->name, name, first);
        else if (child->most > 1 && count == child->most + 1)
            pp_mistakes_add(mistakes, c->line,
                            "%s: exceeds the limit of %d <%s> elements", rule->name,
                            child->most, name);
    }
    if (count < child->least && !may_be_fewer) {
        pp_mistakes_add(mistakes, element->line,
                        "%s: there are %d <%s>; expected at least %d", rule->name,
                        count, name, child->least);
        return false;
    }
    return child->most == 0 || count <= child->most;
}

bool pp_element_form_check_children(const struct pp_element_rule *rule,
                                    const struct pp_xml_element *element,
                                    struct pp_mistakes *mistakes)
{
    /* A truncated element may have lost children, and an unknown child may be a
     * misspelt required one; missing children are then not reported. */
    bool known = !element->ended || children_known(rule, element, mistakes);
    bool good = known;
    for (int i = 0; i < rule->child_count; i++)
        good = count_is_good(rule, &rule->children[i], element,
                             !element->ended || !known, mistakes)
               && good;
    return good;
}
