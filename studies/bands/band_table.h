/* band_table.h - the bands fitted to the atlases supplied with the program, compiled
 * in. There is a table for rooms under the overcast sky (tables/atlas_bands.csv) and
 * one for the skies of ISO 15469 (tables/atlas_bands_iso.csv). Both have the format
 * written by `pepperpot atlas FILE --bands`. */
#ifndef PP_STUDIES_BANDS_BAND_TABLE_H
#define PP_STUDIES_BANDS_BAND_TABLE_H

#include "studies/bands/band_features.h"
#include "studies/bands/band_fit.h"

struct pp_band_table;
extern const struct pp_band_table pp_band_table_overcast, pp_band_table_iso;

/* Table for rooms under this sky; NULL: none. */
const struct pp_band_table *pp_band_table_under(const struct pp_sky *sky);

/* Entry of a table: the bands of a column in one regime. */
struct pp_band_record {
    enum pp_band_place place;
    enum pp_component component;
    const char *column; /* name of the column; static string */
    struct pp_band_entry entry;
};

/* Gets record `index` of the table. Returns false if there is none. */
bool pp_band_table_at(struct pp_band_record *record, const struct pp_band_table *table,
                      int index);

/* Index of the first record of each column, stored because a search would read the
 * whole table. */
enum { PP_BAND_COLUMNS = 128 };
struct pp_band_index {
    const struct pp_band_table *table;
    int count;
    int first[PP_BAND_COLUMNS];
};
void pp_band_table_index(struct pp_band_index *index,
                         const struct pp_band_table *table);

/* All regimes of one column, at points and for averages. Counts are 0 if the atlas does
 * not have the column. */
enum { PP_BAND_REGIMES = 20 };
struct pp_band_regimes {
    int count[PP_BAND_PLACES];
    struct pp_band_record records[PP_BAND_PLACES][PP_BAND_REGIMES];
};
void pp_band_table_find(struct pp_band_regimes *regimes,
                        const struct pp_band_index *index, enum pp_component component,
                        const char *column);

/* Finds the regime of a column, at points or for averages, that contains the features.
 * NULL: none. */
const struct pp_band_record *pp_band_table_regime(const struct pp_band_regimes *regimes,
                                                  enum pp_band_place place,
                                                  const double *features);

/* Least and greatest value of a feature of rooms or points in the atlas. Returns false
 * if they are unknown. */
bool pp_band_table_span(double *from, double *to, const struct pp_band_table *table,
                        int feature);

/* Number of rooms in the atlas. */
int pp_band_table_rooms(const struct pp_band_table *table);

#endif
