/* reader.c - see reader.h. */
#include "model/room/read/reader.h"

#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/room/read/element_form.h"

bool pp_reader_should_stop(const struct pp_reader *r)
{
    return r->out_of_memory || r->bad_elements > PP_MISTAKES_MOST;
}

bool pp_reader_reserve(struct pp_reader *r, void *list, int count, size_t size)
{
    if (pp_array_append(list, count, size, NULL) == PP_OK)
        return true;
    r->out_of_memory = true;
    return false;
}

char *pp_reader_copy_text(struct pp_reader *r, const char *text)
{
    char *copy = text ? strdup(text) : NULL;
    if (text && !copy)
        r->out_of_memory = true;
    return copy;
}

char *pp_reader_path(struct pp_reader *r, const char *file)
{
    const char *before = file[0] == '/' ? "" : r->folder;
    char *path = malloc(strlen(before) + strlen(file) + 1);
    if (path)
        strcat(strcpy(path, before), file);
    else
        r->out_of_memory = true;
    return path;
}

bool pp_reader_fill_form(struct pp_reader *r, void *form,
                         const struct pp_element_rule *rule,
                         const struct pp_xml_element *element)
{
    if (pp_reader_should_stop(r))
        return false;
    bool good = pp_element_form_fill(form, rule, element, r->per_metre, r->materials,
                                     r->mistakes);
    good = pp_element_form_check_children(rule, element, r->mistakes) && good;
    r->bad_elements += !good;
    return good && element->ended;
}

bool pp_reader_add_vertices(struct pp_reader *r, struct pp_vertices *vertices,
                            const struct pp_element_rule *rule,
                            const struct pp_xml_element *parent)
{
    bool good = true;
    for (const struct pp_xml_element *c = parent->child; c && !pp_reader_should_stop(r);
         c = c->next) {
        struct pp_vertex_form form = {0};
        if (!pp_element_form_matches(c, rule))
            continue;
        if (!pp_reader_fill_form(r, &form, rule, c)) {
            good = false;
            continue;
        }
        int count = vertices->count;
        if (!PP_READER_RESERVE(r, vertices->lines, count)
            || !PP_READER_RESERVE(r, vertices->list, count))
            return false;
        vertices->lines[count] = c->line;
        vertices->list[count] = pp_vec(form.x, form.y, form.z);
        vertices->count++;
    }
    return good && !pp_reader_should_stop(r);
}
