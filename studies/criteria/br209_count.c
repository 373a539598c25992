/* br209_count.c - see br209_count.h. */
#include "studies/criteria/br209_count.h"

#include <stdio.h>

#include "model/base/text.h"

const double pp_loss_bands[PP_LOSS_BANDS] = {0.0, 0.2, 0.3, 0.4};

static const struct pp_finding_list *findings_of(const struct pp_assessment *room,
                                                 const struct pp_criterion *criterion)
{
    for (int i = 0; i < room->answer_count; i++)
        if (room->answers[i].criterion == criterion)
            return &room->answers[i].findings;
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

/* Counts each window once: by its former value if it was compared with one, else by 27
 * %. */
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
        count_windows(&sum, &rooms[i]);
        count_room(&sum, &rooms[i]);
    }
    return sum;
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
