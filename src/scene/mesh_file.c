/* Loads mesh files in a process of their own.
 *
 * assimp 5.2.4 ends the whole process on some malformed files (failed assertions, invalid memory) and
 * never returns from others. A mesh is therefore imported by a child, which sends it through a pipe: one
 * struct reply, then the three arrays. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/files.h"
#include "scene/mesh_import.h"

/* Honest files take well under a second and 64 times their size in memory. */
#define SECONDS_ALLOWED 10.0
#define SECONDS_PER_BYTE 1e-6
#define BYTES_ALLOWED ((rlim_t)4 << 30)
#define BYTES_PER_BYTE 64

struct reply {
    int status;
    struct rl_error error;
    uint64_t hash;
    size_t n_vertices, n_triangles;
};

/* ---- The child ---- */

static void send_bytes(int fd, const void *data, size_t size)
{
    const char *at = data;
    while (size > 0) {
        ssize_t n = write(fd, at, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            _exit(1);
        at += n;
        size -= (size_t)n;
    }
}

/* Some files announce more vertices than any machine holds. A process that has mapped a terabyte already
 * (a sanitizer's shadow) gets no limit. */
static void limit_memory(size_t file_size)
{
    char text[64] = "";
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file)
        return;
    bool known = fgets(text, sizeof text, file) != NULL;
    fclose(file);
    rlim_t now = (rlim_t)strtoull(text, NULL, 10) * (rlim_t)sysconf(_SC_PAGESIZE);
    if (!known || now >= (rlim_t)1 << 40)
        return;
    rlim_t limit = now + BYTES_ALLOWED + BYTES_PER_BYTE * (rlim_t)file_size;
    setrlimit(RLIMIT_AS, &(struct rlimit){limit, limit});
}

/* No core file, no output, the usual meaning of signals, and no life without the parent. */
static void settle_child(void)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
}

static _Noreturn void run_child(int fd, uint64_t hash, const char *path, const char *data, size_t size)
{
    settle_child();
    limit_memory(size);
    struct rl_mesh mesh;
    struct reply reply;
    memset(&reply, 0, sizeof reply);
    reply.hash = hash;
    reply.status = rl_mesh_import(&mesh, &reply.hash, path, data, size, &reply.error);
    reply.n_vertices = mesh.n_vertices;
    reply.n_triangles = mesh.n_triangles;
    send_bytes(fd, &reply, sizeof reply);
    if (reply.status == RL_OK) {
        send_bytes(fd, mesh.position, mesh.n_vertices * sizeof *mesh.position);
        send_bytes(fd, mesh.normal, mesh.n_vertices * sizeof *mesh.normal);
        send_bytes(fd, mesh.triangle, mesh.n_triangles * sizeof *mesh.triangle);
    }
    _exit(0);
}

/* ---- The parent ---- */

struct child {
    pid_t pid;
    int fd;
    double deadline;
};

enum received { RECEIVED, ENDED, TOO_LATE };

static enum received receive_bytes(const struct child *child, void *data, size_t size)
{
    char *at = data;
    while (size > 0) {
        double left = child->deadline - rl_clock_seconds();
        if (left <= 0.0)
            return TOO_LATE;
        struct pollfd wait = {.fd = child->fd, .events = POLLIN};
        if (poll(&wait, 1, (int)(1000.0 * left) + 1) <= 0)
            continue;
        ssize_t n = read(child->fd, at, size);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return ENDED;
        at += n;
        size -= (size_t)n;
    }
    return RECEIVED;
}

static enum received receive_mesh(const struct child *child, struct rl_mesh *mesh)
{
    enum received result = receive_bytes(child, mesh->position, mesh->n_vertices * sizeof *mesh->position);
    if (result == RECEIVED)
        result = receive_bytes(child, mesh->normal, mesh->n_vertices * sizeof *mesh->normal);
    if (result == RECEIVED)
        result = receive_bytes(child, mesh->triangle, mesh->n_triangles * sizeof *mesh->triangle);
    return result;
}

static int fail_ended(int wait_status, const char *path, struct rl_error *error)
{
    int number = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
    if (number == SIGINT || number == SIGTERM)
        return rl_fail(error, RL_ERR_CANCELLED, "%s: interrupted while being read", path);
    if (number)
        return rl_fail(error, RL_ERR_INPUT, "%s: found what makes assimp crash (%s), expected a mesh", path,
                       strsignal(number));
    return rl_fail(error, RL_ERR_INPUT, "%s: found what makes assimp end without an answer, expected a mesh",
                   path);
}

static int import_apart(struct rl_mesh *mesh, uint64_t *hash, const char *path, const char *data, size_t size,
                        struct rl_error *error)
{
    int pipe_fd[2];
    if (pipe2(pipe_fd, O_CLOEXEC) != 0)
        return rl_fail(error, RL_ERR_SYSTEM, "%s: cannot make a pipe: %s", path, strerror(errno));
    struct child child = {.pid = fork(), .fd = pipe_fd[0]};
    if (child.pid == 0)
        run_child(pipe_fd[1], *hash, path, data, size);
    close(pipe_fd[1]);
    int status = RL_OK, wait_status = 0;
    if (child.pid < 0) {
        close(child.fd);
        return rl_fail(error, RL_ERR_SYSTEM, "%s: cannot start a process: %s", path, strerror(errno));
    }
    double seconds = SECONDS_ALLOWED + SECONDS_PER_BYTE * (double)size;
    child.deadline = rl_clock_seconds() + seconds;
    struct reply reply;
    enum received result = receive_bytes(&child, &reply, sizeof reply);
    if (result == RECEIVED && reply.status == RL_OK) {
        status = rl_mesh_allocate(mesh, reply.n_vertices, reply.n_triangles, error);
        if (status == RL_OK)
            result = receive_mesh(&child, mesh);
        *hash = reply.hash;
    } else if (result == RECEIVED) {
        status = rl_fail(error, reply.error.status, "%s", reply.error.message);
    }
    if (result == TOO_LATE || status != RL_OK)
        kill(child.pid, SIGKILL);
    close(child.fd);
    while (waitpid(child.pid, &wait_status, 0) < 0 && errno == EINTR)
        continue;
    if (result == TOO_LATE)
        status =
            rl_fail(error, RL_ERR_INPUT,
                    "%s: found what assimp does not finish within %.0f s, expected a mesh", path, seconds);
    else if (result == ENDED)
        status = fail_ended(wait_status, path, error);
    return status;
}

static bool is_ply(const char *data, size_t size, const char *path)
{
    const char *dot = strrchr(path, '.');
    return (dot && strcasecmp(dot, ".ply") == 0) ||
           (size >= 4 && memcmp(data, "ply", 3) == 0 && (data[3] == '\n' || data[3] == '\r'));
}

int rl_mesh_load(struct rl_mesh *mesh, uint64_t *hash, const char *path, struct rl_error *error)
{
    *mesh = (struct rl_mesh){0};
    uint64_t unused = 0;
    char *data;
    size_t size;
    int status = rl_file_read(&data, &size, path, error);
    if (status != RL_OK)
        return status;
    if (size == 0)
        status = rl_fail(error, RL_ERR_INPUT, "%s: found an empty file, expected a mesh", path);
    else if (is_ply(data, size, path))
        status = rl_ply_check(data, size, path, error);
    if (status == RL_OK)
        status = import_apart(mesh, hash ? hash : &unused, path, data, size, error);
    free(data);
    if (status != RL_OK)
        rl_mesh_clear(mesh);
    return status;
}
