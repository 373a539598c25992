/* atlas_bands.h - fits the bands of all columns of an atlas, and tests them on rooms
 * that were not used for the fit. */
#ifndef PP_STUDIES_BANDS_ATLAS_BANDS_H
#define PP_STUDIES_BANDS_ATLAS_BANDS_H

#include "studies/research/atlas/atlas_table.h"
#include "studies/bands/band_features.h"
#include "studies/bands/band_fit.h"

/* Bands of the ratios of one column, at points or of averages. */
struct pp_atlas_column {
    enum pp_band_place place;
    char component[8], name[48];
    struct pp_band_entry *entries; /* from all rooms */
    int entry_count;
    struct pp_band_trial *trials; /* from half of the rooms, tested on the others */
    int trial_count;
    double inside; /* share of all tested points (or averages) inside their bands */
};

/* Span of a feature over the rooms of the atlas. */
struct pp_atlas_span {
    double from, to;
};

struct pp_atlas_bands {
    int rooms;
    bool iso; /* skies of the rooms: those of ISO 15469, or the overcast one */
    struct pp_atlas_span spans[PP_ROOM_FEATURES];
    struct pp_atlas_column *columns;
    int column_count;
};

/* Fits bands to every hand column whose simulated values are in the table. The caller
 * clears *bands in any case. */
enum pp_status pp_atlas_bands_fit(struct pp_atlas_bands *bands,
                                  const struct pp_atlas_table *table,
                                  struct pp_error *err);
/* True if the share of a trial's points inside the band differs from 95 % by more than
 * trial->limit. If the share is too large, it is tested again without points on the
 * band's ends. pp_atlas_bands_outside counts such trials. */
bool pp_atlas_bands_is_outside(const struct pp_band_trial *trial);
int pp_atlas_bands_outside(const struct pp_atlas_bands *bands);

void pp_atlas_bands_clear(struct pp_atlas_bands *bands);

#endif
