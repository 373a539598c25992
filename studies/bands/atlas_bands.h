/* atlas_bands.h - fits bands to all columns of an atlas, and tests them on rooms that
 * were not used in the fit. */
#ifndef PP_STUDIES_BANDS_ATLAS_BANDS_H
#define PP_STUDIES_BANDS_ATLAS_BANDS_H

#include "studies/research/atlas/atlas_table.h"
#include "studies/bands/band_features.h"
#include "studies/bands/band_fit.h"

/* Bands of one column, at points or for averages. */
struct pp_atlas_column {
    enum pp_band_place place;
    char component[8], name[48];
    struct pp_band_entry *entries; /* bands fitted to all rooms */
    int entry_count;
    struct pp_band_trial *trials; /* bands fitted to half of the rooms and tested on the
                                   * other half */
    int trial_count;
    double inside; /* fraction of all tested points (or averages) that are inside their
                    * bands */
};

/* Range of a feature over the rooms of the atlas. */
struct pp_atlas_span {
    double from, to;
};

struct pp_atlas_bands {
    int rooms;
    bool iso; /* skies of the rooms: true: skies of ISO 15469; false: overcast sky */
    struct pp_atlas_span spans[PP_ROOM_FEATURES];
    struct pp_atlas_column *columns;
    int column_count;
};

/* Fits bands to every hand column for which the table has simulated values. The caller
 * clears *bands, also after a failure. */
enum pp_status pp_atlas_bands_fit(struct pp_atlas_bands *bands,
                                  const struct pp_atlas_table *table,
                                  struct pp_error *err);
/* The first function is true if the fraction of a trial's points inside the band
 * differs from 95 % by more than trial->limit. If the fraction is too large, it is
 * tested again without the points that lie exactly on an end of the band. The second
 * function counts such trials. */
bool pp_atlas_bands_is_outside(const struct pp_band_trial *trial);
int pp_atlas_bands_outside(const struct pp_atlas_bands *bands);

void pp_atlas_bands_clear(struct pp_atlas_bands *bands);

#endif
