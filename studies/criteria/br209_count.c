/* br209_count.c - see br209_count.h. */
#include "studies/criteria/br209_count.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"

const double pp_loss_bands[PP_LOSS_BANDS] = {0.0, 0.2, 0.3, 0.4};

static const struct pp_finding_list *findings_of(const struct pp_assessment *room,
                                                 const struct pp_criterion *criterion)
{
    for (int i = 0; i < room->answers.count; i++)
        if (room->answers.list[i].criterion == criterion)
            return &room->answers.list[i].findings;
    return NULL;
}

static bool is_judged(const struct pp_finding *finding)
{
    return finding->verdict == PP_MET || finding->verdict == PP_NOT_MET
           || finding->verdict == PP_UNDECIDED;
}

static void count_loss(struct pp_br209_count *count, const struct pp_finding *finding)
{
    if (!(finding->before > 0.0))
        return;
    double loss = 1.0 - finding->now / finding->before;
    int band = 0;
    while (band + 1 < PP_LOSS_BANDS && loss >= pp_loss_bands[band + 1])
        band++;
    count->losses[band]++;
    count->compared++;
}

/* Counts each window once: by comparison with its former value if there is one, else by
 * the target of 27 %. */
static void count_windows(struct pp_br209_count *count,
                          const struct pp_assessment *room)
{
    const struct pp_finding_list *now = findings_of(room, &pp_criterion_vertical_sky);
    const struct pp_finding_list *then = findings_of(room, &pp_criterion_former_sky);
    const struct pp_finding_list *any = then ? then : now;
    for (int i = 0; any && i < any->count; i++) {
        const struct pp_finding *finding = &any->list[i];
        if (then)
            count_loss(count, finding);
        if (!is_judged(finding) && now && i < now->count)
            finding = &now->list[i];
        count->windows += is_judged(finding);
        count->windows_met += finding->verdict == PP_MET;
    }
}

static void count_room(struct pp_br209_count *count, const struct pp_assessment *room)
{
    const struct pp_finding_list *area = findings_of(room, &pp_criterion_no_sky_line);
    bool judged = false, met = true;
    for (int i = 0; area && i < area->count; i++)
        if (is_judged(&area->list[i])) {
            judged = true;
            met &= area->list[i].verdict == PP_MET;
        }
    count->rooms += judged;
    count->rooms_met += judged && met;
}

struct pp_br209_count pp_br209_count_of(const struct pp_assessment *rooms, int count)
{
    struct pp_br209_count sum = {0};
    for (int i = 0; i < count; i++) {
        if (rooms[i].is_new)
            continue;
        count_windows(&sum, &rooms[i]);
        count_room(&sum, &rooms[i]);
    }
    return sum;
}

/* ---- by floor and house ---- */

#define SAME_FLOOR_M 0.5

static const char *house_of(const struct pp_assessment *room)
{
    const char *address = room->room->world->address;
    return address ? address : room->room->file;
}

static void add_count(struct pp_br209_count *sum, const struct pp_br209_count *other)
{
    sum->windows += other->windows;
    sum->windows_met += other->windows_met;
    sum->rooms += other->rooms;
    sum->rooms_met += other->rooms_met;
    sum->compared += other->compared;
    for (int i = 0; i < PP_LOSS_BANDS; i++)
        sum->losses[i] += other->losses[i];
}

static int compare_levels(const void *a, const void *b)
{
    const struct pp_br209_group *one = a, *other = b;
    return (one->level_m > other->level_m) - (one->level_m < other->level_m);
}

/* Adds the room to the group of its floor among the groups from index `first`, or to a
 * new one. */
static enum pp_status add_to_floor(struct pp_br209_group **groups, int first,
                                   int *group_count, const struct pp_assessment *room,
                                   struct pp_error *err)
{
    const struct pp_br209_count own = pp_br209_count_of(room, 1);
    const double level_m = room->room->world->placement.z;
    if (own.windows + own.rooms == 0)
        return PP_OK;
    int i = first;
    while (i < *group_count && fabs((*groups)[i].level_m - level_m) >= SAME_FLOOR_M)
        i++;
    if (i == *group_count) {
        if (pp_array_append(groups, *group_count, sizeof **groups, err) != PP_OK)
            return PP_SYSTEM;
        (*groups)[(*group_count)++] =
            (struct pp_br209_group){.house = house_of(room), .level_m = level_m};
    }
    add_count(&(*groups)[i].count, &own);
    return PP_OK;
}

/* Adds the floors of a house, the lowest first, and the sum of the house if it has
 * several. */
static enum pp_status add_house(struct pp_br209_group **groups, int *group_count,
                                const char *house, const struct pp_assessment *rooms,
                                int count, struct pp_error *err)
{
    const int first = *group_count;
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++)
        if (strcmp(house_of(&rooms[i]), house) == 0 && !rooms[i].is_new)
            status = add_to_floor(groups, first, group_count, &rooms[i], err);
    const int floors = *group_count - first;
    if (status != PP_OK || floors < 2)
        return status;
    qsort(*groups + first, (size_t)floors, sizeof **groups, compare_levels);
    if (pp_array_append(groups, *group_count, sizeof **groups, err) != PP_OK)
        return PP_SYSTEM;
    struct pp_br209_group sum = {.house = house, .is_house = true, .level_m = NAN};
    for (int i = first; i < first + floors; i++)
        add_count(&sum.count, &(*groups)[i].count);
    (*groups)[(*group_count)++] = sum;
    return PP_OK;
}

enum pp_status pp_br209_count_groups(struct pp_br209_group **groups, int *group_count,
                                     const struct pp_assessment *rooms, int count,
                                     struct pp_error *err)
{
    enum pp_status status = PP_OK;
    *groups = NULL;
    *group_count = 0;
    for (int i = 0; i < count && status == PP_OK; i++) {
        bool is_first = true;
        for (int k = 0; k < i && is_first; k++)
            is_first = strcmp(house_of(&rooms[k]), house_of(&rooms[i])) != 0;
        if (is_first)
            status =
                add_house(groups, group_count, house_of(&rooms[i]), rooms, count, err);
    }
    return status;
}

void pp_br209_count_group_words(char words[PP_BR209_WORDS],
                                const struct pp_br209_group *groups, int count,
                                int index)
{
    const struct pp_br209_group *group = &groups[index];
    const char *slash = strrchr(group->house, '/');
    words[0] = '\0';
    if (strcmp(groups[0].house, groups[count - 1].house) != 0)
        pp_text_append(words, PP_BR209_WORDS, "%.60s, ",
                       slash ? slash + 1 : group->house);
    if (group->is_house)
        pp_text_append(words, PP_BR209_WORDS, "all floors");
    else
        pp_text_append(words, PP_BR209_WORDS, "floor at %+.2f m", group->level_m);
}

void pp_br209_count_words(char words[PP_BR209_WORDS],
                          const struct pp_br209_count *count)
{
    words[0] = '\0';
    if (count->windows > 0)
        snprintf(words, PP_BR209_WORDS, "%d of %d window%s", count->windows_met,
                 count->windows, count->windows == 1 ? "" : "s");
    if (count->rooms > 0)
        pp_text_append(words, PP_BR209_WORDS, "%s%d of %d room%s",
                       count->windows > 0 ? " and " : "", count->rooms_met,
                       count->rooms, count->rooms == 1 ? "" : "s");
    if (words[0])
        pp_text_append(words, PP_BR209_WORDS, " meet%s BR 209",
                       count->windows + count->rooms == 1 ? "s" : "");
}
