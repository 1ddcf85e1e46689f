// Evaluates one row of arguments: not a pass of a frame, but how functions of other modules are called one by one.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Arguments
{
    float arguments[];
};
layout(std430, binding = 1) writeonly buffer Results
{
    float results[];
};

void main()
{
    uint row = gl_GlobalInvocationID.x;
    if (row * N_OUT >= results.length())
        return;
    float a[N_IN];
    float r[N_OUT];
    for (int i = 0; i < N_IN; i++)
        a[i] = arguments[row * N_IN + i];
    evaluate(a, r);
    for (int i = 0; i < N_OUT; i++)
        results[row * N_OUT + i] = r[i];
}
