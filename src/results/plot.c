/* Starts gnuplot, waits, and hands on what it complained about (see plot.h). */
#include "results/plot.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/machine.h"
#include "base/paths.h"

enum { OUTPUT_MAX = 8192 };

/* Reads all of `fd`, keeps the first OUTPUT_MAX - 1 bytes. */
static void read_output(int fd, char output[OUTPUT_MAX])
{
    size_t kept = 0;
    char block[1024];
    for (;;) {
        ssize_t n = read(fd, block, sizeof block);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            break;
        size_t room = OUTPUT_MAX - 1 - kept;
        size_t take = (size_t)n < room ? (size_t)n : room;
        memcpy(output + kept, block, take);
        kept += take;
    }
    output[kept] = '\0';
}

/* gnuplot echoes the line, points at the place with ^ and ends with "file" line 3: message. The last line that is not empty. */
static const char *last_line(char *text)
{
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] == '\n' || text[length - 1] == ' '))
        text[--length] = '\0';
    const char *newline = strrchr(text, '\n');
    return newline ? newline + 1 : text;
}

/* Numbers and messages as in C, whatever the user's language is. */
static char **environment_in_c(void)
{
    size_t n = 0;
    while (environ[n])
        n++;
    char **copy = malloc((n + 2) * sizeof *copy);
    if (!copy)
        return NULL;
    size_t kept = 0;
    for (size_t i = 0; i < n; i++)
        if (strncmp(environ[i], "LC_ALL=", 7) != 0)
            copy[kept++] = environ[i];
    static char language[] = "LC_ALL=C";
    copy[kept++] = language;
    copy[kept] = NULL;
    return copy;
}

static int start(pid_t *pid, int pipe_end[2], char *const argv[], struct rl_error *error)
{
    char **environment = environment_in_c();
    if (!environment)
        return rl_fail_memory(error, "gnuplot's environment");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe_end[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipe_end[1], STDERR_FILENO);
    int code = posix_spawnp(pid, argv[0], &actions, NULL, argv, environment);
    posix_spawn_file_actions_destroy(&actions);
    free(environment);
    if (code == ENOENT)
        return rl_fail(error, RL_ERR_UNAVAILABLE,
                       "gnuplot: not found on the PATH; the report's plots need it");
    if (code != 0)
        return rl_fail(error, RL_ERR_UNAVAILABLE, "gnuplot: cannot be started: %s", strerror(code));
    return RL_OK;
}

/* What a script says with `exit status 3`; gnuplot itself ends with 1 on an error. */
enum { EXIT_NOTHING_TO_DRAW = 3 };

static int run_gnuplot(char *const argv[], const char *script, struct rl_error *error)
{
    int pipe_end[2];
    if (pipe2(pipe_end, O_CLOEXEC) != 0)
        return rl_fail(error, RL_ERR_SYSTEM, "gnuplot: cannot make a pipe: %s", strerror(errno));
    pid_t pid = 0;
    int status = start(&pid, pipe_end, argv, error);
    close(pipe_end[1]);
    if (status == RL_OK) {
        char output[OUTPUT_MAX];
        read_output(pipe_end[0], output);
        int ended = 0;
        while (waitpid(pid, &ended, 0) < 0 && errno == EINTR)
            continue;
        if (WIFEXITED(ended) && WEXITSTATUS(ended) == EXIT_NOTHING_TO_DRAW)
            status = rl_fail(error, RL_ERR_CHECK, "plots/%s: nothing to draw: no value is positive", script);
        else if (!WIFEXITED(ended) || WEXITSTATUS(ended) != 0)
            status = rl_fail(error, RL_ERR_SYSTEM, "plots/%s: gnuplot failed: %s", script, last_line(output));
    }
    close(pipe_end[0]);
    return status;
}

static int script_path(char path[PATH_MAX], const char *script, struct rl_error *error)
{
    char relative[128];
    snprintf(relative, sizeof relative, "plots/%s", script);
    return rl_path_data(path, PATH_MAX, relative, error);
}

int rl_plot(const char *script, const char *const arguments[], struct rl_error *error)
{
    char path[PATH_MAX], style[PATH_MAX];
    int status = script_path(path, script, error);
    if (status == RL_OK)
        status = script_path(style, "style.gp", error);
    if (status != RL_OK)
        return status;
    /* posix_spawn takes char *const, but does not write to the words. */
    char *argv[RL_PLOT_ARGUMENTS_MAX + 5] = {(char *)"gnuplot", (char *)"-c", path, style};
    for (size_t i = 0; i < RL_PLOT_ARGUMENTS_MAX && arguments[i]; i++)
        argv[4 + i] = (char *)arguments[i];
    return run_gnuplot(argv, script, error);
}

static int draw(struct rl_plot_figure *f, struct rl_error *error)
{
    char all[PATH_MAX], style[PATH_MAX], script[PATH_MAX];
    int status = script_path(all, "figure.gp", error);
    if (status == RL_OK)
        status = script_path(style, "style.gp", error);
    if (status == RL_OK)
        status = script_path(script, f->script, error);
    if (status != RL_OK)
        return status;
    char *argv[] = {(char *)"gnuplot", (char *)"-c",     all, style, script, (char *)f->tables, f->stem,
                    (char *)f->name,   (char *)f->scene, NULL};
    return run_gnuplot(argv, f->script, error);
}

/* What gnuplot left behind before it found nothing to draw. */
static void remove_pictures(const struct rl_plot_figure *f)
{
    static const char *const ending[] = {"svg", "png", "small.png"};
    char path[PATH_MAX + 16];
    for (size_t k = 0; k < sizeof ending / sizeof ending[0]; k++) {
        snprintf(path, sizeof path, "%s.%s", f->stem, ending[k]);
        remove(path);
    }
}

/* What the threads share. */
struct drawing {
    struct rl_plot_figure *figure;
    size_t n, next, done;
    const struct rl_progress *progress;
    pthread_mutex_t lock; /* of all that follows and of next and done */
    int status;
    struct rl_error error;
};

/* The next figure, or NULL if there is none or it is time to stop. */
static struct rl_plot_figure *take(struct drawing *d)
{
    struct rl_plot_figure *f = NULL;
    pthread_mutex_lock(&d->lock);
    if (d->status == RL_OK && rl_progress_cancelled(d->progress))
        d->status = rl_fail(&d->error, RL_ERR_CANCELLED, "interrupted while the plots were drawn");
    if (d->status == RL_OK && d->next < d->n)
        f = &d->figure[d->next++];
    pthread_mutex_unlock(&d->lock);
    return f;
}

static void finish(struct drawing *d, struct rl_plot_figure *f, int status, const struct rl_error *error)
{
    pthread_mutex_lock(&d->lock);
    f->missing = status == RL_ERR_CHECK; /* one scene without a highlight, say, does not cost the page */
    if (f->missing)
        remove_pictures(f);
    /* Ctrl-C on a terminal ends gnuplot as well: that is no fault of the figure. */
    else if (status != RL_OK && d->status == RL_OK && !rl_progress_cancelled(d->progress)) {
        d->status = status;
        d->error = *error;
    }
    rl_progress_update(d->progress, "plots", ++d->done, d->n);
    pthread_mutex_unlock(&d->lock);
}

static void *work(void *user)
{
    struct drawing *d = user;
    for (struct rl_plot_figure *f; (f = take(d));) {
        struct rl_error error = {0};
        int status = draw(f, &error);
        finish(d, f, status, &error);
    }
    return NULL;
}

int rl_plot_figures(struct rl_plot_figure *figures, size_t n, int threads, const struct rl_progress *progress,
                    struct rl_error *error)
{
    enum { THREADS_MAX = 64 };
    struct drawing d = {.figure = figures, .n = n, .progress = progress, .lock = PTHREAD_MUTEX_INITIALIZER};
    pthread_t thread[THREADS_MAX];
    int started = 0, wanted = threads > 0 ? threads : rl_machine_threads();
    /* This thread is one of them; where no more can be started, it does all. */
    while (started + 1 < wanted && started < THREADS_MAX &&
           pthread_create(&thread[started], NULL, work, &d) == 0)
        started++;
    work(&d);
    while (started > 0)
        pthread_join(thread[--started], NULL);
    pthread_mutex_destroy(&d.lock);
    if (d.status != RL_OK && error)
        *error = d.error;
    return d.status;
}
