#!/usr/bin/python3
"""A server made with pymodbus on a serial device: pymodbus_server.py DEVICE ADDRESS"""
import asyncio
import sys

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.device import ModbusDeviceIdentification
from pymodbus.server import StartAsyncSerialServer
from pymodbus.transaction import ModbusRtuFramer


async def main():
    identity = ModbusDeviceIdentification()
    identity.VendorName = "pymodbus"
    identity.ProductCode = "PM"
    identity.MajorMinorRevision = "3.0"
    identity.ModelName = "a peer"
    device = ModbusSlaveContext(
        di=ModbusSequentialDataBlock(0, [bit % 3 == 0 for bit in range(100)]),
        co=ModbusSequentialDataBlock(0, [False] * 2000),
        hr=ModbusSequentialDataBlock(0, [0] * 1000),
        ir=ModbusSequentialDataBlock(0, [word * 257 for word in range(200)]),
        zero_mode=True)
    context = ModbusServerContext(slaves={int(sys.argv[2]): device}, single=False)
    await StartAsyncSerialServer(context=context, identity=identity, framer=ModbusRtuFramer, port=sys.argv[1],
                                 baudrate=19200, parity="N", stopbits=1, ignore_missing_slaves=True,
                                 broadcast_enable=True)


asyncio.run(main())
