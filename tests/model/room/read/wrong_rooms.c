/* wrong_rooms.c - reads the text files that wrong_rooms.h describes. */
#include "tests/model/room/read/wrong_rooms.h"

#include <ctype.h>
#include <dirent.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/read_file.h"

enum { LINE_MOST = 4096, BASE_MOST = 100000 };

/* A text file, and the case being read. */
struct reader {
    struct wrong_rooms *rooms;
    const char *folder, *file;
    int at; /* line in the text file */
    char *base;
    size_t base_length;

    struct wrong_room room;
    FILE *bytes;      /* bytes of the room; NULL between two cases */
    const char *rest; /* the base room from line `next` on, not yet copied or omitted */
    int next;
};

static void refuse(const struct reader *reader, const char *why)
{
    fprintf(stderr, "%s:%d: %s\n", reader->file, reader->at, why);
    exit(2);
}

static char *copy_of(const char *text)
{
    char *copy = strdup(text);
    if (!copy)
        abort();
    return copy;
}

static void read_base(struct reader *reader, const char *name)
{
    char path[2 * PATH_MAX];
    struct pp_error err = {0};
    snprintf(path, sizeof path, "%s/%s", reader->folder, name);
    free(reader->base);
    if (pp_read_file(&reader->base, &reader->base_length, path, BASE_MOST, &err)
        != PP_OK)
        refuse(reader, err.message);
}

static void begin_case(struct reader *reader, const char *title)
{
    if (!reader->base)
        refuse(reader, "a title before the first base room");
    if (wrong_rooms_find(reader->rooms, title))
        refuse(reader, "another room has this title");
    reader->room = (struct wrong_room){
        .file = copy_of(reader->file), .at = reader->at, .title = copy_of(title)};
    reader->bytes = open_memstream(&reader->room.bytes, &reader->room.length);
    reader->rest = reader->base;
    reader->next = 1;
}

/* Advances to the line after `last` of the base room; copies the lines or omits
 * them. */
static void pass_base(struct reader *reader, int last, bool take)
{
    if (last < reader->next - 1)
        refuse(reader, "line numbers that are not in order");
    for (; reader->next <= last; reader->next++) {
        size_t left = reader->base_length - (size_t)(reader->rest - reader->base);
        const char *end = memchr(reader->rest, '\n', left);
        if (!end)
            refuse(reader, "a line number behind the end of the base room");
        if (take)
            fwrite(reader->rest, 1, (size_t)(end + 1 - reader->rest), reader->bytes);
        reader->rest = end + 1;
    }
}

static void write_line(struct reader *reader, const char *text)
{
    for (; *text; text++) {
        char digits[3] = "";
        if (*text != '\\') {
            fputc(*text, reader->bytes);
        } else if (text[1] == 'x' && isxdigit((unsigned char)text[2])
                   && isxdigit((unsigned char)text[3])) {
            memcpy(digits, text + 2, 2);
            fputc((int)strtol(digits, NULL, 16), reader->bytes);
            text += 3;
        } else if (text[1] == '\0') {
            return;
        } else {
            refuse(reader, "a \\ that is neither \\xNN nor at the end");
        }
    }
    fputc('\n', reader->bytes);
}

/* "N |TEXT", "N +TEXT", "N -" or "N-M -". */
static void edit(struct reader *reader, const char *line)
{
    char *behind;
    int first = (int)strtol(line, &behind, 10), last = first;
    if (behind == line)
        refuse(reader, "expected a line number or =>");
    if (*behind == '-')
        last = (int)strtol(behind + 1, &behind, 10);
    behind += strspn(behind, " ");
    bool range = last != first;
    if (*behind == '-' && behind[1] == '\0' && last >= first) {
        pass_base(reader, first - 1, true);
        pass_base(reader, last, false);
    } else if (*behind == '|' && !range) {
        pass_base(reader, first - 1, true);
        pass_base(reader, first, false);
        write_line(reader, behind + 1);
    } else if (*behind == '+' && !range) {
        pass_base(reader, first, true);
        write_line(reader, behind + 1);
    } else {
        refuse(reader, "expected | or + and a text, or -, behind the line number");
    }
}

/* "=> line N, KIND: WORDS" ends a case. */
static void expect(struct reader *reader, const char *line)
{
    static const char *const kinds[] = {
        [WRONG_XML] = "xml", [WRONG_FORM] = "form", [WRONG_SENSE] = "sense"};
    struct wrong_room *room = &reader->room;
    char kind[8];
    int words = 0, known = 0;
    if (sscanf(line, "=> line %d, %7[a-z]: %n", &room->line, kind, &words) != 2
        || line[words] == '\0')
        refuse(reader, "expected => line N, KIND: WORDS");
    while (known < 3 && strcmp(kinds[known], kind) != 0)
        known++;
    if (known == 3)
        refuse(reader, "expected xml, form or sense");
    room->kind = (enum wrong_kind)known;
    room->words = copy_of(line + words);
    fwrite(reader->rest, 1, reader->base_length - (size_t)(reader->rest - reader->base),
           reader->bytes);
    fclose(reader->bytes);
    reader->bytes = NULL;
    struct wrong_rooms *rooms = reader->rooms;
    if (pp_array_append(&rooms->list, rooms->count, sizeof *rooms->list, NULL) != PP_OK)
        abort();
    rooms->list[rooms->count++] = *room;
}

static void read_line(struct reader *reader, const char *line)
{
    const char *text = line + strspn(line, " ");
    if (line[0] == '#')
        return;
    if (*text == '\0') {
        if (reader->bytes)
            refuse(reader, "a case ends without =>");
    } else if (text > line) {
        if (!reader->bytes)
            refuse(reader, "a case without a title");
        if (strncmp(text, "=>", 2) == 0)
            expect(reader, text);
        else
            edit(reader, text);
    } else if (reader->bytes) {
        refuse(reader, "a title within a case");
    } else if (strncmp(line, "base ", 5) == 0) {
        read_base(reader, line + 5);
    } else {
        begin_case(reader, line);
    }
}

static void read_text_file(struct wrong_rooms *rooms, const char *folder,
                           const char *file)
{
    struct reader reader = {.rooms = rooms, .folder = folder, .file = file};
    char path[1024], line[LINE_MOST];
    snprintf(path, sizeof path, "%s/%s", folder, file);
    FILE *in = fopen(path, "r");
    if (!in)
        refuse(&reader, "the file cannot be read");
    while (fgets(line, sizeof line, in)) {
        reader.at++;
        size_t length = strcspn(line, "\n");
        if (line[length] == '\0')
            refuse(&reader, "a line that is too long, or has no end");
        line[length] = '\0';
        read_line(&reader, line);
    }
    if (reader.bytes)
        refuse(&reader, "the last case ends without =>");
    fclose(in);
    free(reader.base);
}

static int is_text_file(const struct dirent *entry)
{
    size_t length = strlen(entry->d_name);
    return length > 4 && strcmp(entry->d_name + length - 4, ".txt") == 0;
}

void wrong_rooms_read(struct wrong_rooms *rooms, const char *folder)
{
    struct dirent **files;
    *rooms = (struct wrong_rooms){0};
    int count = scandir(folder, &files, is_text_file, alphasort);
    if (count < 1) {
        fprintf(stderr, "%s: no .txt file is there\n", folder);
        exit(2);
    }
    for (int i = 0; i < count; i++) {
        read_text_file(rooms, folder, files[i]->d_name);
        free(files[i]);
    }
    free(files);
}

void wrong_rooms_clear(struct wrong_rooms *rooms)
{
    for (int i = 0; i < rooms->count; i++) {
        free(rooms->list[i].file);
        free(rooms->list[i].title);
        free(rooms->list[i].bytes);
        free(rooms->list[i].words);
    }
    free(rooms->list);
    *rooms = (struct wrong_rooms){0};
}

const struct wrong_room *wrong_rooms_find(const struct wrong_rooms *rooms,
                                          const char *title)
{
    for (int i = 0; i < rooms->count; i++)
        if (strcmp(rooms->list[i].title, title) == 0)
            return &rooms->list[i];
    return NULL;
}
