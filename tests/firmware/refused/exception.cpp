// EXPECT: undefined reference to `__exidx_start'
int main()
{
    throw 1;
}
