/* number_list.c - see number_list.h. */
#include "model/light/bsdf/number_list.h"

#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

static bool separates(char c)
{
    return c == ',' || pp_text_is_white(c);
}

static bool ends_list(char c)
{
    return c == '\0' || c == '{' || c == '}';
}

const char *pp_number_list_skip(const char *text)
{
    while (separates(*text))
        text++;
    return text;
}

bool pp_number_list_read(struct pp_number_list *numbers, const char **text, int most)
{
    for (;;) {
        const char *at = *text = pp_number_list_skip(*text);
        char word[64];
        double value;
        if (ends_list(*at))
            return true;
        while (!separates(*at) && !ends_list(*at))
            at++;
        size_t length = (size_t)(at - *text);
        if (length >= sizeof word || numbers->count == most)
            return false;
        memcpy(word, *text, length);
        word[length] = '\0';
        if (!pp_text_parse_number(word, &value))
            return false;
        if (pp_array_reserve(&numbers->list, &numbers->capacity, numbers->count + 1,
                             sizeof *numbers->list, NULL)
            != PP_OK) {
            numbers->out_of_memory = true;
            return false;
        }
        numbers->list[numbers->count++] = value;
        *text = at;
    }
}
