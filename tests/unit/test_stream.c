/* Lines of files (input/delimited/delimited.h) against the lines they were made of: long and empty
 * ones, both line ends, a last line without an end, places gone back to, the limit, pipes, and
 * beginnings. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <dirent.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "../lib/random.h"
#include "input/delimited/delimited.h"
#include "fixture.h"

enum { LINES = 9 };

/* A text and the lines it has: where each starts, its bytes with what may be stripped from them. */
typedef struct sample {
    char *text;
    size_t length, count;
    size_t start[LINES], size[LINES]; /* without the line end */
    int cr[LINES], ended[LINES], mark;
    char path[64];
} sample;

static void write_sample(sample *s) {
    strcpy(s->path, "/tmp/graze-stream-XXXXXX");
    int fd = mkstemp(s->path);
    assert_true(fd >= 0);
    for (size_t done = 0; done < s->length;) {
        ssize_t n = write(fd, s->text + done, s->length - done);
        assert_true(n > 0);
        done += (size_t)n;
    }
    close(fd);
}

/* File descriptors in use. */
static int descriptors(void) {
    DIR *folder = opendir("/proc/self/fd");
    int count = -1; /* that of the folder itself */
    assert_non_null(folder);
    while (readdir(folder))
        count++;
    closedir(folder);
    return count;
}

/* Lines of lengths around those of the buffers. */
static void make_sample(sample *s) {
    static const size_t sizes[] = {0, 1, 2, 40, 16383, 16384, 16385, 65535, 65536, 65537, 150000};
    memset(s, 0, sizeof *s);
    s->text = malloc(LINES * 150010);
    assert_non_null(s->text);
    s->count = 1 + draw_below(LINES);
    s->mark = draw_below(2) == 0;
    if (s->mark)
        s->length = (size_t)sprintf(s->text, "\xef\xbb\xbf");
    for (size_t k = 0; k < s->count; k++) {
        size_t size = sizes[draw_below(sizeof sizes / sizeof *sizes)];
        s->ended[k] = k + 1 < s->count || draw_below(2) == 0;
        s->cr[k] = draw_below(3) == 0;
        size += !s->ended[k] && size == 0; /* or there is no such line */
        s->start[k] = s->length;
        s->size[k] = size;
        for (size_t i = 0; i < size; i++)
            s->text[s->length++] = (char)('a' + (i + k) % 26);
        if (s->cr[k])
            s->text[s->length++] = '\r';
        if (s->ended[k])
            s->text[s->length++] = '\n';
    }
    write_sample(s);
}

static void clear_sample(sample *s) {
    unlink(s->path);
    free(s->text);
}

/* The next line is line k; a file of others loses its mark and its CR. */
static void expect_line(stream *in, const sample *s, size_t k) {
    field line;
    assert_int_equal(stream_next(in, &line), GRAZE_OK);
    if (k == s->count) {
        assert_null(line.start);
        return;
    }
    size_t before = in->own && k == 0 && s->mark ? 3 : 0;
    assert_non_null(line.start);
    assert_int_equal(line.length, before + s->size[k] + (in->own && s->cr[k]));
    assert_memory_equal(line.start, s->text + s->start[k] - before, line.length);
    assert_int_equal(in->whole, s->ended[k]);
}

static void expect_all(stream *in, const sample *s) {
    for (size_t k = 0; k < s->count; k++) {
        expect_line(in, s, k);
        assert_int_equal(in->line, k + 1);
    }
    expect_line(in, s, s->count);
    expect_line(in, s, s->count);
    stream_close(in);
}

/* A copy made line by line is the file. */
static void expect_copy(const sample *s) {
    stream in;
    text copy;
    field line;
    text_init(&copy);
    assert_int_equal(stream_open_own(&in, context, s->path, 0), GRAZE_OK);
    for (;;) {
        assert_int_equal(stream_next(&in, &line), GRAZE_OK);
        if (!line.start)
            break;
        stream_copy_line(&copy, &in, line);
    }
    assert_int_equal(copy.length, s->length);
    assert_memory_equal(copy.data, s->text, s->length);
    text_clear(&copy);
    stream_close(&in);
}

/* Back to the lines in any order. */
static void expect_places(const sample *s, int reopened) {
    stream in;
    long long place[LINES];
    assert_int_equal(stream_open_own(&in, context, s->path, reopened), GRAZE_OK);
    assert_int_equal(stream_repeatable(&in), !reopened);
    for (size_t k = 0; k < s->count; k++) {
        place[k] = stream_tell(&in);
        assert_int_equal(place[k], k ? s->start[k] : 0);
        expect_line(&in, s, k);
    }
    for (int round = 0; round < 12; round++) {
        size_t k = draw_below((unsigned)s->count);
        assert_int_equal(stream_seek(&in, place[k]), GRAZE_OK);
        expect_line(&in, s, k);
        expect_line(&in, s, k + 1);
    }
    stream_close(&in);
}

static void lines_are_those_written(void **state) {
    (void)state;
    random_start(41);
    int before = descriptors();
    for (int round = 0; round < 40; round++) {
        sample s;
        stream in;
        make_sample(&s);
        assert_int_equal(stream_open(&in, context, s.path), GRAZE_OK);
        assert_true(stream_repeatable(&in));
        expect_all(&in, &s);
        stream_of_text(&in, context, "a text", s.text, s.length);
        assert_false(stream_repeatable(&in));
        expect_all(&in, &s);
        expect_copy(&s);
        expect_places(&s, 0);
        expect_places(&s, 1);
        clear_sample(&s);
        assert_int_equal(descriptors(), before);
    }
}

/* Closing, twice too, takes the stream's own descriptor alone. */
static void closing_spares_other_files(void **state) {
    (void)state;
    sample s = {.text = strdup("a\n"), .length = 2};
    stream in;
    int input = dup(STDIN_FILENO), before;
    assert_non_null(s.text);
    write_sample(&s);
    int file = open(s.path, O_RDONLY);
    assert_int_equal(dup2(file, STDIN_FILENO), STDIN_FILENO);
    close(file);
    before = descriptors();
    assert_int_equal(stream_open(&in, context, "-"), GRAZE_OK);
    assert_string_equal(in.name, "standard input");
    assert_false(stream_repeatable(&in)); /* though it is a file */
    stream_close(&in);
    stream_close(&in);
    stream_of_text(&in, context, "a text", s.text, s.length);
    stream_close(&in);
    assert_int_equal(stream_open_own(&in, context, s.path, 1), GRAZE_OK);
    stream_close(&in);
    assert_int_equal(descriptors(), before);
    dup2(input, STDIN_FILENO);
    close(input);
    clear_sample(&s);
}

/* A line as long as the limit passes, one longer is refused by its number; a file of Graze's own
 * has no limit. */
static void limit_holds_for_one_line(void **state) {
    (void)state;
    static const size_t sizes[] = {100, 65535, 65536, 70000, 140000};
    assert_int_equal(graze_context_set_limit(context, GRAZE_LIMIT_LINE, 70000), GRAZE_OK);
    for (size_t k = 0; k < 5; k++)
        for (size_t more = 0; more < 2; more++) {
            sample s = {.count = 2};
            size_t size = (sizes[k] < 70000 ? sizes[k] : sizes[k] / 70000 * 70000) + more;
            stream in;
            field line;
            s.text = malloc(size + 3);
            assert_non_null(s.text);
            memset(s.text, 'x', size + 2);
            s.text[1] = s.text[size + 2] = '\n';
            s.length = size + 3;
            write_sample(&s);
            assert_int_equal(stream_open(&in, context, s.path), GRAZE_OK);
            assert_int_equal(stream_next(&in, &line), GRAZE_OK);
            graze_status status = stream_next(&in, &line);
            assert_int_equal(status, size > 70000 ? GRAZE_ELIMIT : GRAZE_OK);
            if (status == GRAZE_OK)
                assert_int_equal(line.length, size);
            else
                assert_non_null(strstr(graze_context_message(context), ":2: "));
            stream_close(&in);
            assert_int_equal(stream_open_own(&in, context, s.path, 0), GRAZE_OK);
            assert_int_equal(stream_next(&in, &line), GRAZE_OK);
            assert_int_equal(stream_next(&in, &line), GRAZE_OK);
            assert_int_equal(line.length, size);
            stream_close(&in);
            clear_sample(&s);
        }
}

/* A pipe is ready once a whole line or its end is there. */
static void pipe_is_ready_with_a_line(void **state) {
    (void)state;
    int ends[2];
    char path[32];
    stream in;
    field line;
    assert_int_equal(pipe(ends), 0);
    snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
    assert_int_equal(stream_open(&in, context, path), GRAZE_OK);
    assert_false(stream_repeatable(&in));
    assert_false(stream_ready(&in));
    assert_int_equal(write(ends[1], "a", 1), 1);
    assert_false(stream_ready(&in));
    assert_int_equal(write(ends[1], "bcd\ne\nf", 7), 7);
    assert_true(stream_ready(&in));
    assert_int_equal(stream_next(&in, &line), GRAZE_OK);
    assert_memory_equal(line.start, "abcd", 4);
    assert_true(stream_ready(&in));
    assert_int_equal(stream_next(&in, &line), GRAZE_OK);
    assert_false(stream_ready(&in));
    /* Lines that are gone leave their bytes behind those in use: `fg`, newline, `d`, newline. */
    assert_int_equal(write(ends[1], "g\nd", 3), 3);
    assert_true(stream_ready(&in));
    assert_int_equal(stream_next(&in, &line), GRAZE_OK);
    assert_memory_equal(line.start, "fg", 2);
    assert_false(stream_ready(&in));
    close(ends[1]);
    assert_true(stream_ready(&in));
    assert_int_equal(stream_next(&in, &line), GRAZE_OK);
    assert_int_equal(line.length, 1);
    assert_int_equal(*line.start, 'd');
    assert_int_equal(stream_next(&in, &line), GRAZE_OK);
    assert_null(line.start);
    stream_close(&in);
    close(ends[0]);
}

/* A pipe into which a child writes two parts, one after the other. */
static void begin_parts(char *path, size_t room, int *end) {
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    snprintf(path, room, "/dev/fd/%d", ends[0]);
    *end = ends[0];
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        struct timespec wait = {0, 100000000};
        int good = write(ends[1], "abcdefghij", 10) == 10;
        nanosleep(&wait, NULL);
        _exit(!good || write(ends[1], "klmnopqrstuvwxyz", 16) != 16);
    }
    close(ends[1]);
}

/* The first bytes of a file, and nothing behind the room for them. */
static void beginning_keeps_to_its_room(void **state) {
    (void)state;
    static const size_t sizes[] = {0, 1, 14, 15, 16, 17, 40};
    int before = descriptors();
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        char text[80];
        size_t length = 99, wanted = sizes[k] < 15 ? sizes[k] : 15;
        sample s = {.text = malloc(41), .length = sizes[k]};
        assert_non_null(s.text);
        memset(s.text, 'q', 41);
        memset(text, 'z', sizeof text);
        write_sample(&s);
        assert_int_equal(stream_beginning(text, 16, &length, context, s.path), GRAZE_OK);
        assert_int_equal(length, wanted);
        assert_memory_equal(text, s.text, wanted);
        assert_int_equal(text[wanted], 0);
        for (size_t i = 16; i < sizeof text; i++)
            assert_int_equal(text[i], 'z');
        clear_sample(&s);
        assert_int_equal(descriptors(), before);
    }
    char path[32], text[80];
    size_t length;
    int end, status;
    memset(text, 'z', sizeof text);
    begin_parts(path, sizeof path, &end);
    assert_int_equal(stream_beginning(text, 16, &length, context, path), GRAZE_OK);
    assert_int_equal(length, 15);
    assert_memory_equal(text, "abcdefghijklmno", 16);
    for (size_t i = 16; i < sizeof text; i++)
        assert_int_equal(text[i], 'z');
    wait(&status);
    assert_int_equal(status, 0);
    close(end);
}

static void other_files_are_refused(void **state) {
    (void)state;
    static const char *const paths[] = {"/tmp", "/tmp/graze-no-such-file", "/dev/null/x"};
    char text[16];
    size_t length;
    stream in;
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(stream_open(&in, context, paths[k]), GRAZE_ESYSTEM);
        stream_close(&in);
        assert_int_equal(stream_open_own(&in, context, paths[k], 0), GRAZE_ESYSTEM);
        stream_close(&in);
        assert_int_equal(stream_beginning(text, 16, &length, context, paths[k]), GRAZE_ESYSTEM);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(lines_are_those_written, set_up, tear_down),
        cmocka_unit_test_setup_teardown(closing_spares_other_files, set_up, tear_down),
        cmocka_unit_test_setup_teardown(limit_holds_for_one_line, set_up, tear_down),
        cmocka_unit_test_setup_teardown(pipe_is_ready_with_a_line, set_up, tear_down),
        cmocka_unit_test_setup_teardown(beginning_keeps_to_its_room, set_up, tear_down),
        cmocka_unit_test_setup_teardown(other_files_are_refused, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
