/* site_page.c - see site_page.h. */
#include "reports/page/site_page.h"

#include <math.h>
#include <string.h>

#include "reports/assess/finding_cells.h"
#include "reports/page/html.h"
#include "reports/parts/figure_unit.h"
#include "reports/parts/print.h"
#include "studies/criteria/site_table.h"

static const char more_style[] =
    ".facts td{text-align:left;vertical-align:top;white-space:normal}.facts "
    "td:first-child{color:"
    "var(--soft);white-space:nowrap;width:8rem}\n"
    ".pictures{display:flex;flex-wrap:wrap;gap:1rem}"
    "figure{margin:0;flex:1 1 22rem;min-width:0}"
    "figure svg{width:100%;height:auto;background:#fff;border:1px solid var(--line)}"
    "figcaption{color:var(--soft);font-size:.9rem}\n"
    "@media print{body{max-width:none;padding:0;font-size:11pt}section{break-before:"
    "page}tr,figure{break-inside:avoid}}\n";

static void put_cell(const char *text, const char *kind, FILE *out)
{
    fprintf(out, kind ? "<td class=\"%s\">" : "<td>", kind);
    pp_html_text(text, out);
    fputs("</td>", out);
}

static void put_number(double value, int decimals, FILE *out)
{
    if (isfinite(value))
        fprintf(out, "<td>%.*f</td>", decimals, value + 0.0);
    else
        fputs("<td>–</td>", out);
}

static void put_verdict(const struct pp_finding *finding, FILE *out)
{
    const char *word = pp_finding_verdict(finding->verdict);
    put_cell(word ? word : "",
             finding->verdict == PP_MET       ? "w good"
             : finding->verdict == PP_NOT_MET ? "w bad"
                                              : "w",
             out);
}

/* ---- the site ---- */

/* of: what the second column names; NULL: there is none. */
static void put_rows(const char *title, const char *of, const char *unit,
                     const struct pp_site_row *rows, int count, FILE *out)
{
    if (count == 0)
        return;
    fprintf(out,
            "<h3>%s</h3>\n<div class=\"wide\"><table>\n<tr><th class=\"w\">room</th>"
            "%s%s%s<th>existing, %s</th><th>proposed, %s</th>"
            "<th>ratio</th><th class=\"w\">verdict</th></tr>\n",
            title, of ? "<th class=\"w\">" : "", of ? of : "", of ? "</th>" : "", unit,
            unit);
    for (int i = 0; i < count; i++) {
        const struct pp_world *world = rows[i].room->room->world;
        double scale = pp_figure_scale(rows[i].finding->compared);
        fputs("<tr>", out);
        put_cell(world->name ? world->name : "", "w", out);
        if (of)
            put_cell(rows[i].finding->what, "w", out);
        put_number(scale * rows[i].existing, 2, out);
        put_number(scale * rows[i].proposed, 2, out);
        put_number(rows[i].ratio, 3, out);
        put_verdict(rows[i].finding, out);
        fputs("</tr>\n", out);
    }
    fputs("</table></div>\n", out);
}

static enum pp_status put_site(const struct pp_assessments *all, FILE *out,
                               struct pp_error *err)
{
    struct pp_site_table table;
    enum pp_status status = pp_site_table_of(&table, all->list, all->count, err);
    if (status == PP_OK && table.window_count + table.room_count > 0) {
        fputs("<h2>Sky of windows and rooms</h2>\n", out);
        put_rows("Vertical sky component [BR209]", "window", "%", table.windows,
                 table.window_count, out);
        put_rows("Area of the working plane that sees sky [BR209]", NULL, "m²",
                 table.rooms, table.room_count, out);
    }
    if (status == PP_OK)
        put_rows("Share of gardens with two hours of sun on 21 March [BR209]", "garden",
                 "%", table.gardens, table.garden_count, out);
    pp_site_table_clear(&table);
    return status;
}

/* ---- a room ---- */

static void put_fact(void *closure, const char *label, const char *text)
{
    FILE *out = closure;
    fputs("<tr>", out);
    put_cell(label, NULL, out);
    put_cell(text, NULL, out);
    fputs("</tr>\n", out);
}

static void put_facts(const struct pp_assessment *room, FILE *out)
{
    const struct pp_world *world = room->room->world;
    fputs("<div class=\"wide\"><table class=\"facts\">\n", out);
    if (world->ref)
        put_fact(out, "reference", world->ref);
    if (world->use)
        put_fact(out, "use", pp_room_use_words[world->use]);
    pp_print_facts(world, &room->room->light, put_fact, out);
    fputs("</table></div>\n", out);
}

static void put_pictures(const struct pp_site_page *page, int room, FILE *out)
{
    bool any = false;
    for (int i = 0; i < page->picture_count; i++) {
        const struct pp_site_picture *picture = &page->pictures[i];
        if (picture->room != room)
            continue;
        /* Behind the declaration, which a page has not. */
        const char *svg = strstr(picture->svg, "<svg");
        fputs(any ? "" : "<div class=\"pictures\">\n", out);
        any = true;
        fputs("<figure>", out);
        if (svg)
            fwrite(svg, 1, picture->length - (size_t)(svg - picture->svg), out);
        fputs("<figcaption>", out);
        pp_html_text(picture->title, out);
        fputs("</figcaption></figure>\n", out);
    }
    fputs(any ? "</div>\n" : "", out);
}

/* Averages over the working plane, by each method that has one. */
static void put_averages(const struct pp_assessment *room, FILE *out)
{
    const struct pp_report *report = &room->report;
    if (report->column_count == 0)
        return;
    fputs("<h3>Average daylight factor over the working plane</h3>\n"
          "<div class=\"wide\"><table>\n<tr><th class=\"w\">by</th><th>average, %</th>"
          "<th>± standard error</th><th>95 % band</th></tr>\n",
          out);
    for (int i = 0; i < report->column_count; i++) {
        const struct pp_column *column = &report->columns[i];
        if (column->component != PP_DF || !isfinite(column->average.value))
            continue;
        fputs("<tr>", out);
        put_cell(column->name, "w", out);
        put_number(100.0 * column->average.value, 2, out);
        put_number(100.0 * column->average.std_error, 3, out);
        if (pp_band_is_known(column->average_band))
            fprintf(out, "<td>%.2f–%.2f</td>", 100.0 * column->average_band.low,
                    100.0 * column->average_band.high);
        else
            fputs("<td>–</td>", out);
        fputs("</tr>\n", out);
    }
    fputs(
        "</table></div>\n<p class=\"soft\">95 % band: where the true figure was in 95 "
        "of 100 rooms like this one, of those that the program has traced.</p>\n",
        out);
}

static void put_answer(const struct pp_answer *answer, FILE *out)
{
    const struct pp_finding_list *findings = &answer->findings;
    fputs("<tr><th class=\"w\" colspan=\"4\">", out);
    pp_html_text(answer->criterion->title, out);
    fputs(" [", out);
    pp_html_text(answer->criterion->source, out);
    fputs("]</th></tr>\n", out);
    if (findings->basis[0]) {
        fputs("<tr><td class=\"w soft\" colspan=\"4\">", out);
        pp_html_text(findings->basis, out);
        fputs("</td></tr>\n", out);
    }
    for (int i = 0; i < findings->count; i++) {
        const struct pp_finding *finding = &findings->list[i];
        char figure[PP_FINDING_CELL], wanted[PP_FINDING_CELL];
        pp_finding_cells_figure(figure, finding, true);
        pp_finding_cells_wanted(wanted, finding, true);
        fputs("<tr><td class=\"w\">", out);
        pp_html_text(finding->what, out);
        if (finding->note[0]) {
            fputs("<br><span class=\"soft\">", out);
            pp_html_text(finding->note, out);
            fputs("</span>", out);
        }
        fputs("</td>", out);
        put_cell(figure, NULL, out);
        put_cell(wanted, NULL, out);
        put_verdict(finding, out);
        fputs("</tr>\n", out);
    }
}

static void put_answers(const struct pp_assessment *room, FILE *out)
{
    if (room->answer_count == 0) {
        fputs("<p>Of what was asked for nothing bears on this room.</p>\n", out);
        return;
    }
    fputs("<h3>What it has to reach</h3>\n<div class=\"wide\"><table>\n", out);
    for (int i = 0; i < room->answer_count; i++)
        put_answer(&room->answers[i], out);
    fputs("</table></div>\n", out);
}

static void put_gains(const struct pp_gains *gains, FILE *out)
{
    char sentence[256];
    if (!gains->method || gains->count == 0)
        return;
    pp_gains_sentence(gains, sentence, sizeof sentence);
    fputs("<h3>What would help</h3>\n<p>", out);
    pp_html_text(sentence, out);
    fprintf(out,
            "</p>\n<div class=\"wide\"><table>\n<tr><th class=\"w\">change</th>"
            "<th>average, %%, by %s</th><th>gained</th></tr>\n",
            gains->method);
    for (int i = 0; i < gains->count; i++) {
        const struct pp_gain *gain = &gains->list[i];
        fputs("<tr>", out);
        put_cell(gain->change, "w", out);
        put_number(100.0 * gain->values.average, 2, out);
        fprintf(out, "<td>%+.0f %%</td></tr>\n",
                100.0 * (gain->values.average / gains->now.average - 1.0));
    }
    fputs("</table></div>\n", out);
}

static void put_room(const struct pp_site_page *page, int index, FILE *out)
{
    const struct pp_assessment *room = &page->all->list[index];
    const char *name = room->room->world->name;
    fputs("<section>\n<h2>", out);
    pp_html_text(name ? name : "Room", out);
    fputs("</h2>\n", out);
    put_facts(room, out);
    put_pictures(page, index, out);
    put_averages(room, out);
    put_answers(room, out);
    if (room->has_gains)
        put_gains(&room->gains, out);
    fputs("</section>\n", out);
}

/* ---- the page ---- */

static void put_sum(const struct pp_assessments *all, FILE *out)
{
    static const enum pp_verdict verdicts[] = {PP_MET, PP_NOT_MET, PP_UNDECIDED,
                                               PP_NOT_JUDGED};
    const char *before = "";
    fputs("<p class=\"verdict\">", out);
    for (int v = 0; v < 4; v++) {
        int count = 0;
        for (int i = 0; i < all->count; i++)
            for (int k = 0; k < all->list[i].answer_count; k++) {
                const struct pp_finding_list *list = &all->list[i].answers[k].findings;
                for (int n = 0; n < list->count; n++)
                    count += list->list[n].verdict == verdicts[v];
            }
        if (count == 0)
            continue;
        fprintf(out, "%s%d %s", before, count, pp_finding_verdict(verdicts[v]));
        before = ", ";
    }
    fprintf(out, "%s of %d room%s</p>\n", *before ? "" : "no verdicts", all->count,
            all->count == 1 ? "" : "s");
}

static void put_foot(const struct pp_site_page *page, FILE *out)
{
    const struct pp_study_options *options = page->all->options;
    fputs("<section>\n<h2>How this was made</h2>\n<p>pepperpot ", out);
    pp_html_text(page->version, out);
    fputs(": <code>", out);
    pp_html_text(page->made_by, out);
    fputs("</code></p>\n<p>", out);
    if (options->simulate)
        fprintf(out,
                "Traced figures are simulated, with one standard error behind ±; seed "
                "%llu. The same file, options and seed give the same figures. ",
                (unsigned long long)options->seed);
    else
        fputs("Nothing is simulated: figures are those of hand methods. ", out);
    fputs("Keys in square brackets are those of the program's list of sources.</p>\n"
          "</section>\n",
          out);
}

enum pp_status pp_site_page(const struct pp_site_page *page, FILE *out,
                            struct pp_error *err)
{
    const struct pp_assessments *all = page->all;
    bool finished = true;
    for (int i = 0; i < all->count; i++)
        finished &= all->list[i].report.finished;
    pp_html_begin(page->title, more_style, out);
    fputs("<h1>", out);
    pp_html_text(page->title, out);
    fputs("</h1>\n<p class=\"soft\">Daylight: ", out);
    pp_html_text(all->count ? all->list[0].room->file : "", out);
    fprintf(out, "%s</p>\n", finished ? "" : "; NOT FINISHED, interrupted");
    put_sum(all, out);
    enum pp_status status = put_site(all, out, err);
    for (int i = 0; i < all->count; i++)
        put_room(page, i, out);
    put_foot(page, out);
    pp_html_end(out);
    return status;
}
