/* leed.c - LEED v4.1, daylight, option 1: spatial daylight autonomy and annual sunlight
 * exposure of the room, by a simulated year (studies/year/annual.h).
 *
 *   mean sDA300/50 of all regularly occupied area   40, 55, 75 %: 1, 2, 3 points
 *   ASE1000,250 above 10 %                          a statement on glare is required
 *
 * Thresholds are those of public descriptions of the credit; its text was not available.
 * The room represents all regularly occupied area.
 */
#include "model/results/sheets/lm83_grid.h"
#include "studies/criteria/criteria.h"
#include "studies/criteria/rules/rule_year.h"

static const double steps[] = {0.40, 0.55, 0.75};
static const double ase_most = 0.10;

static enum pp_status add_credit_points(const struct pp_annual_sheet *year,
                                        struct pp_finding_list *findings,
                                        struct pp_error *err)
{
    static const char *const names[] = {"sDA300/50, 1 point", "sDA300/50, 2 points",
                                        "sDA300/50, 3 points"};
    enum pp_status status = PP_OK;
    char grid[PP_LM83_GRID_WORDS];
    pp_lm83_grid_words(grid, year);
    for (int i = 0; i < 3 && status == PP_OK; i++) {
        struct pp_finding finding =
            pp_rule_year_share(&year->plane.sda, steps[i], false, names[i]);
        finding.is_optional = i > 0;
        if (i == 0)
            pp_finding_note(&finding,
                            "LEED uses the mean of all regularly occupied area, which "
                            "this room represents here");
        if (i == 0 && grid[0])
            pp_finding_note(&finding, "; %s", grid);
        status = pp_finding_list_add(findings, &finding, err);
    }
    return status;
}

static enum pp_status add_exposure(const struct pp_annual_sheet *year,
                                   struct pp_finding_list *findings,
                                   struct pp_error *err)
{
    struct pp_finding finding =
        pp_rule_year_share(&year->plane.ase, ase_most, true, "ASE1000,250");
    finding.is_optional = true;
    if (finding.verdict != PP_MET)
        pp_finding_note(&finding, "explain how the space is protected from glare");
    return pp_finding_list_add(findings, &finding, err);
}

static enum pp_status evaluate_leed(const struct pp_inquiry *inquiry,
                                    struct pp_finding_list *findings,
                                    struct pp_error *err)
{
    const struct pp_annual_sheet *year = inquiry->year;
    const char *why_not =
        !year ? "no year was simulated for this room; expected --weather FILE.epw"
        : !year->finished ? "the simulation of the year was interrupted"
                          : pp_annual_sheet_leed(year).why_not;
    if (why_not) {
        struct pp_finding finding =
            pp_finding_not_judged(why_not, "sDA300/50 and ASE1000,250");
        return pp_finding_list_add(findings, &finding, err);
    }
    pp_finding_list_add_basis(
        findings, "simulated for every hour of a year, as by annual, at %d points",
        year->receiver_count);
    enum pp_status status = add_credit_points(year, findings, err);
    return status == PP_OK ? add_exposure(year, findings, err) : status;
}

const struct pp_criterion pp_criterion_leed = {
    .name = "leed-v4.1",
    .title = "LEED v4.1, daylight, option 1",
    .source = "LM83",
    .summary = "LEED v4.1: sDA and ASE by a simulated year; needs --weather, and is "
               "assessed only if named",
    .of_year = true,
    .evaluate = evaluate_leed,
};
