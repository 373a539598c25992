/* trees_note.c - see trees_note.h. */
#include "reports/assess/trees_note.h"

#include "model/base/text.h"
#include "reports/parts/json.h"
#include "studies/criteria/trees_left_out.h"
#include "studies/criteria/windows/opening_words.h"

static void add_criterion(struct pp_trees_left_out *trees,
                          const struct pp_criterion *criterion)
{
    for (int i = 0; i < trees->count; i++)
        if (trees->criteria[i] == criterion)
            return;
    trees->criteria[trees->count++] = criterion;
}

/* Index of the room in which a crown rises highest, with that crown and the criteria of
 * all rooms; -1: none. */
static int highest_of(struct pp_trees_left_out *highest,
                      const struct pp_assessment *rooms, int count)
{
    int found = -1;
    *highest = (struct pp_trees_left_out){0};
    for (int i = 0; i < count; i++) {
        struct pp_trees_left_out trees;
        if (!pp_trees_left_out_find(&trees, &rooms[i]))
            continue;
        for (int k = 0; k < trees.count; k++)
            add_criterion(highest, trees.criteria[k]);
        if (trees.altitude_rad <= highest->altitude_rad)
            continue;
        highest->opening = trees.opening;
        highest->line = trees.line;
        highest->altitude_rad = trees.altitude_rad;
        found = i;
    }
    return found;
}

bool pp_trees_note_text(char text[PP_TREES_NOTE_BYTES],
                        const struct pp_assessment *rooms, int count,
                        const char *degree)
{
    enum { SIZE = PP_TREES_NOTE_BYTES };
    struct pp_trees_left_out trees;
    char window[PP_OPENING_WORDS];
    int room = highest_of(&trees, rooms, count);
    if (room < 0)
        return false;
    const struct pp_world *world = rooms[room].room->world;
    snprintf(text, SIZE, "Trees are left out of: ");
    for (int i = 0; i < trees.count; i++)
        pp_text_append(text, SIZE, "%s%s", i > 0 ? "; " : "", trees.criteria[i]->title);
    pp_opening_words(window, world, trees.opening);
    pp_text_append(text, SIZE,
                   ". The tree in line %d rises to %.0f%s above the horizon, seen from "
                   "the window %s",
                   trees.line, trees.altitude_rad / PP_RAD, degree, window);
    if (count > 1 && world->name)
        pp_text_append(text, SIZE, ", of the room %s", world->name);
    pp_text_append(text, SIZE, "; simulations include it.");
    return true;
}

bool pp_trees_note_json(struct json_object *object, const struct pp_assessment *rooms,
                        int count)
{
    struct pp_trees_left_out trees;
    char window[PP_OPENING_WORDS];
    int room = highest_of(&trees, rooms, count);
    if (room < 0)
        return true;
    const struct pp_world *world = rooms[room].room->world;
    pp_opening_words(window, world, trees.opening);
    struct json_object *note = json_object_new_object();
    bool good = pp_json_add(object, "trees_left_out", note);
    struct json_object *list = good ? json_object_new_array() : NULL;
    good = good && pp_json_add(note, "criteria", list);
    for (int i = 0; i < trees.count && good; i++)
        good = pp_json_append(list, json_object_new_string(trees.criteria[i]->name));
    if (good && count > 1)
        good = pp_json_text(note, "room", world->name);
    return good && pp_json_add(note, "line", json_object_new_int(trees.line))
           && pp_json_number(note, "altitude", trees.altitude_rad / PP_RAD)
           && pp_json_text(note, "of", window);
}
